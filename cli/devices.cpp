// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/text_table.hpp"
#include "components/devices/hid/attached_devices.hpp"

namespace trocar::cli {
namespace {

/// Whether this user may open it; "" or why not.
std::string refusal(const hid::AttachedDevice& device) {
  return faccessat(AT_FDCWD, device.path.c_str(), R_OK | W_OK, AT_EACCESS) == 0
             ? ""
             : std::strerror(errno);
}

std::string numbers(const hid::AttachedDevice& device) {
  return fmt::format("{:04x}:{:04x}", device.vendor, device.product);
}

std::string devices_text(const std::vector<hid::AttachedDevice>& devices) {
  if (devices.empty()) return "No HID device is attached.\n";
  TextTable table("", 0);
  table.row({"path", "numbers", "serial", "usage", "opens", "name"});
  for (const hid::AttachedDevice& device : devices) {
    const std::string why = refusal(device);
    table.row({device.path, numbers(device), device.serial.empty() ? "-" : device.serial,
               fmt::format("{:04x}", device.usage_page), why.empty() ? "yes" : "no: " + why,
               device.manufacturer + (device.manufacturer.empty() ? "" : ", ") + device.name});
  }
  return table.text();
}

nlohmann::ordered_json devices_json(const std::vector<hid::AttachedDevice>& devices) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const hid::AttachedDevice& device : devices)
    list.push_back({{"path", device.path},
                    {"vendor", fmt::format("{:04x}", device.vendor)},
                    {"product", fmt::format("{:04x}", device.product)},
                    {"serial", device.serial},
                    {"manufacturer", device.manufacturer},
                    {"name", device.name},
                    {"usage_page", device.usage_page},
                    {"interface", device.interface},
                    {"refusal", refusal(device)}});
  return list;
}

}  // namespace

void add_devices(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("devices", "List the HID devices that are attached");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print JSON");
  command->footer(
      "Example:\n  trocar devices\n"
      "`vendor`, `product`, `serial` and `path` of HidLaparoscope choose one of them;\n"
      "`trocar doctor` says why one cannot be opened, and the cure.");
  command->callback([json, &status] {
    const std::vector<hid::AttachedDevice> devices = hid::attached_devices();
    if (*json)
      print_json(devices_json(devices));
    else
      print(devices_text(devices));
    status = success;
  });
}

}  // namespace trocar::cli
