// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/available.hpp"
#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/preflight.hpp"
#include "cli/script_options.hpp"
#include "framework/scripting/script.hpp"

namespace trocar::cli {
namespace {

Findings findings_of(const ScriptOptions& script, std::size_t& components) {
  const Registry registry = available_components();
  SessionOptions options{.check_only = true};
  Graph::Overrides script_arguments;
  script.split(options.set, script_arguments);
  Session session(registry, options);
  try {
    run_script(session, script.script, std::move(script_arguments));
  } catch (const BrokenGraph& broken) {
    return broken.findings;
  }
  for (NodeId id = 0; id < session.graph().size(); ++id)
    components += session.graph().node(id).is_group() ? 0 : 1;
  return {};
}

nlohmann::ordered_json json_of(const Findings& findings) {
  auto list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings.all())
    list.push_back(
        {{"file", finding.where.file}, {"line", finding.where.line}, {"message", finding.message}});
  return {{"findings", list}};
}

int check(const ScriptOptions& script, bool json) {
  std::size_t components = 0;
  const Findings findings = findings_of(script, components);
  if (json)
    print_json(json_of(findings));
  else if (findings.empty())
    print(fmt::format("{}: {} components, no mistakes\n", script.script, components));
  else
    print(fmt::format("{}{} {}\n", findings.text(), findings.all().size(),
                      findings.all().size() == 1 ? "mistake" : "mistakes"));
  return findings.empty() ? success : misused;
}

int fly(const ScriptOptions& script, const std::string& duration, AllocationCount allocations,
        bool json) {
  const Registry registry = available_components();
  SessionOptions options{.seed = script.seed, .print_to_stderr = json};
  if (!duration.empty()) options.duration = duration_of(duration, "--for");
  options.allocations = allocations;
  options.stop = &stop_on_interrupt();
  Graph::Overrides script_arguments;
  script.split(options.set, script_arguments);
  try {
    const Preflight result =
        preflight(registry, script.script, std::move(options), std::move(script_arguments));
    if (json)
      print_json(preflight_json(result));
    else
      print(fmt::format("{}: {}", script.script, preflight_text(result)));
    return result.failures().empty() ? success : failed;
  } catch (const BrokenGraph& broken) {
    if (json)
      print_json(json_of(broken.findings));
    else
      complain(mistakes_text(broken.findings));
    return misused;
  }
}

}  // namespace

void add_check(CLI::App& app, int& status, AllocationCount allocations) {
  CLI::App* command =
      app.add_subcommand("check", "Find every mistake in a script without running its graph");
  const auto script = std::make_shared<ScriptOptions>();
  const auto json = std::make_shared<bool>(false);
  script->add_to(*command);
  const auto preflight = std::make_shared<bool>(false);
  const auto duration = std::make_shared<std::string>();
  auto* flag = command->add_flag("--preflight", *preflight,
                                 "Run it in virtual time: what steps cost, peaks, what would trip");
  command->add_option("--for", *duration, "How long (default: as the script says, else 10 s)")
      ->needs(flag);
  command->add_flag("--json", *json, "Print JSON");
  command->footer(
      "Example:\n  trocar check scripts/tutorial/01_feel_a_wall.lua\n"
      "  trocar check scripts/tutorial/01_feel_a_wall.lua --preflight --for 5s\n"
      "A script that runs its graph itself is read up to its first trocar.run; a preflight does\n"
      "that run, with the simulated device and hand of the script.\n"
      "Exit status: 0 success, 1 something would trip or allocates, 2 wrong usage or mistakes.");
  command->callback([=, &status] {
    status = *preflight ? fly(*script, *duration, allocations, *json) : check(*script, *json);
  });
}

}  // namespace trocar::cli
