// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <grp.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "cli/diagnosis.hpp"
#include "components/devices/hid/udev_rule.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

using Level = Diagnosis::Level;

constexpr const char* rule_cure =
    "trocar doctor --udev-rule | sudo tee /etc/udev/rules.d/70-trocar.rules\n"
    "sudo udevadm control --reload && sudo udevadm trigger";

bool is_laparoscope(const hid::AttachedDevice& device) {
  return device.vendor == hid::laparoscope_vendor && device.product == hid::laparoscope_product;
}

/// Whether a file of rules names the laparoscope.
bool names_it(const std::filesystem::path& file) {
  const std::string key = hid::udev_key(hid::laparoscope_vendor, hid::laparoscope_product);
  std::ifstream rules(file);
  for (std::string line; std::getline(rules, line);)
    if (!line.starts_with('#') && line.find(key) != std::string::npos) return true;
  return false;
}

Diagnosis udev_rule(const std::string& root) {
  for (const char* folder :
       {"/etc/udev/rules.d", "/run/udev/rules.d", "/usr/local/lib/udev/rules.d",
        "/usr/lib/udev/rules.d", "/lib/udev/rules.d"}) {
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(root + folder, none))
      if (entry.path().extension() == ".rules" && names_it(entry.path()))
        return {"udev_rule", Level::good, "udev rule " + entry.path().string(), ""};
  }
  return {"udev_rule", Level::warning,
          "no udev rule names the laparoscope: when it is attached, only root may open it",
          rule_cure};
}

/// A group that may read and write the file, and that this process is not of; "" if there is none.
std::string group_to_join(const std::string& path) {
  struct stat file {};
  if (stat(path.c_str(), &file) != 0 || (file.st_mode & 0060) != 0060 || file.st_gid == 0)
    return "";
  std::vector<gid_t> own(static_cast<std::size_t>(std::max(0, getgroups(0, nullptr))));
  own.resize(
      static_cast<std::size_t>(std::max(0, getgroups(static_cast<int>(own.size()), own.data()))));
  const bool member =
      getegid() == file.st_gid || std::find(own.begin(), own.end(), file.st_gid) != own.end();
  const group* entry = getgrgid(file.st_gid);
  return member || entry == nullptr ? "" : entry->gr_name;
}

Diagnosis refused(const hid::AttachedDevice& device, int error) {
  const std::string what =
      fmt::format("{} cannot be opened ({})", device.text(), std::strerror(error));
  if (error != EACCES && error != EPERM)
    return {"device", Level::problem, what, "unplug it, and plug it in again"};
  const std::string group = group_to_join(device.path);
  if (group.empty()) return {"device", Level::problem, what, rule_cure};
  const passwd* user = getpwuid(geteuid());
  return {"device", Level::problem, fmt::format("{}: it belongs to the group {}", what, group),
          fmt::format("sudo usermod -aG {} {}    # then log in again", group,
                      user != nullptr ? user->pw_name : std::to_string(geteuid()))};
}

/// As the driver does, which takes a lock for as long as it runs.
Diagnosis openable(const hid::AttachedDevice& device) {
  const int file = open(device.path.c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return refused(device, errno);
  const bool free = flock(file, LOCK_EX | LOCK_NB) == 0;
  close(file);
  if (free) return {"device", Level::good, device.text() + " can be opened", ""};
  return {"device", Level::note, device.text() + " is in use by another trocar", ""};
}

Diagnosis none_attached(std::span<const hid::AttachedDevice> attached, const std::string& root) {
  if (!std::filesystem::exists(root + "/sys/class/hidraw"))
    return {"device", Level::note,
            "no laparoscope, and the kernel has no hidraw: no HID device can be seen",
            "sudo modprobe usbhid    # in a container: run trocar where the devices are"};
  return {"device", Level::note,
          fmt::format(
              "no laparoscope ({:04x}:{:04x}) is attached{}", hid::laparoscope_vendor,
              hid::laparoscope_product,
              attached.empty() ? ", nor any other HID device" : "; `trocar devices` lists what is"),
          "plug it in, and switch it on"};
}

}  // namespace

std::vector<Diagnosis> diagnose_devices(std::span<const hid::AttachedDevice> attached,
                                        const std::string& root) {
  std::vector<Diagnosis> all{udev_rule(root)};
  for (const hid::AttachedDevice& device : attached)
    if (is_laparoscope(device)) all.push_back(openable(device));
  if (all.size() == 1) all.push_back(none_attached(attached, root));
  return all;
}

}  // namespace trocar::cli
