// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/diagnosis.hpp"
#include "cli/output.hpp"
#include "components/devices/hid/udev_rule.hpp"

namespace trocar::cli {
namespace {

int examine(bool json) {
  std::vector<Diagnosis> all = diagnose_machine();
  for (const std::vector<Diagnosis>& more :
       {diagnose_rights(), diagnose_devices(hid::attached_devices())})
    all.insert(all.end(), more.begin(), more.end());
  if (json)
    print_json(diagnoses_json(all));
  else
    print(diagnoses_text(all));
  return sound(all) ? success : failed;
}

}  // namespace

void add_doctor(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "doctor", "Say what keeps this machine from running a device, and the cure");
  const auto json = std::make_shared<bool>(false);
  const auto rule = std::make_shared<bool>(false);
  CLI::Option* as_json = command->add_flag("--json", *json, "Print JSON");
  command->add_flag("--udev-rule", *rule, "Print the laparoscope's rules for udev")
      ->excludes(as_json);
  command->footer(
      "Example:\n  trocar doctor\n"
      "It tries what a run would need, and changes nothing.\n"
      "Exit status: 0 no problem, 1 a problem, 2 wrong usage.");
  command->callback([json, rule, &status] {
    status = success;
    if (*rule)
      print(hid::udev_rules());
    else
      status = examine(*json);
  });
}

}  // namespace trocar::cli
