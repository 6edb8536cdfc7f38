// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/attached_devices.hpp"

#include <fmt/format.h>
#include <hidapi.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "components/devices/hid/hidapi_lock.hpp"
#include "framework/text.hpp"

namespace trocar::hid {
namespace {

/// What is not ASCII becomes a question mark: it is for messages and for comparing.
std::string narrow(const wchar_t* text) {
  std::string result;
  for (; text != nullptr && *text != 0; ++text)
    result += *text >= 0x20 && *text < 0x7F ? static_cast<char>(*text) : '?';
  return result;
}

AttachedDevice device_of(const hid_device_info& info) {
  return {.path = info.path != nullptr ? info.path : "",
          .vendor = info.vendor_id,
          .product = info.product_id,
          .serial = narrow(info.serial_number),
          .manufacturer = narrow(info.manufacturer_string),
          .name = narrow(info.product_string),
          .usage_page = info.usage_page,
          .interface = info.interface_number};
}

/// How much of the selection a device has: to name the nearest.
int likeness(const DeviceSelection& wanted, const AttachedDevice& device) {
  int points = 0;
  if (wanted.vendor == device.vendor) points += 2;
  if (wanted.product == device.product) points += 2;
  if (!wanted.serial.empty() && wanted.serial == device.serial) points += 3;
  return points;
}

std::string list_of(std::span<const AttachedDevice> devices) {
  std::string list;
  for (const AttachedDevice& device : devices) list += "\n  " + device.text();
  return list;
}

[[noreturn]] void none_found(const DeviceSelection& wanted,
                             std::span<const AttachedDevice> attached) {
  std::string message = fmt::format("no HID device is {}", wanted.text());
  if (attached.empty()) throw std::runtime_error(message + "; none at all is attached");
  if (!wanted.path.empty()) {
    std::vector<std::string> paths;
    for (const AttachedDevice& device : attached) paths.push_back(device.path);
    message += suggestion(wanted.path, paths);
  } else {
    const auto nearest = std::max_element(attached.begin(), attached.end(),
                                          [&](const AttachedDevice& a, const AttachedDevice& b) {
                                            return likeness(wanted, a) < likeness(wanted, b);
                                          });
    if (likeness(wanted, *nearest) > 0)
      message += fmt::format("; the nearest is {}", nearest->text());
  }
  throw std::runtime_error(message + "; attached are:" + list_of(attached));
}

}  // namespace

std::string AttachedDevice::text() const {
  std::string text = fmt::format("{} {:04x}:{:04x}", path, vendor, product);
  if (!name.empty()) text += " " + name;
  return text + (serial.empty() ? ", no serial" : ", serial " + serial);
}

std::vector<AttachedDevice> attached_devices() {
  std::vector<AttachedDevice> devices;
  hidapi_lock().run([&] {
    hid_device_info* const first = hid_enumerate(0, 0);
    for (const hid_device_info* info = first; info != nullptr; info = info->next)
      devices.push_back(device_of(*info));
    hid_free_enumeration(first);
  });
  // One device has an entry for each of its top-level collections.
  std::stable_sort(
      devices.begin(), devices.end(),
      [](const AttachedDevice& a, const AttachedDevice& b) { return a.path < b.path; });
  devices.erase(std::unique(devices.begin(), devices.end(),
                            [](const AttachedDevice& a, const AttachedDevice& b) {
                              return a.path == b.path;
                            }),
                devices.end());
  return devices;
}

std::string DeviceSelection::text() const {
  if (!path.empty()) return "at " + path;
  const auto number = [](const std::optional<std::uint16_t>& n) {
    return n ? fmt::format("{:04x}", *n) : std::string("any");
  };
  std::string text = number(vendor) + ":" + number(product);
  for (const std::uint16_t other : or_products) text += " or " + number(other);
  if (!serial.empty()) text += ", serial " + serial;
  return text;
}

bool DeviceSelection::fits(const AttachedDevice& device) const {
  if (!path.empty()) return device.path == path;
  const bool fitting = product.value_or(device.product) == device.product ||
                       std::count(or_products.begin(), or_products.end(), device.product) > 0;
  return vendor.value_or(device.vendor) == device.vendor && fitting &&
         (serial.empty() || serial == device.serial);
}

std::uint16_t usb_number(const std::string& text, const std::string& what) {
  std::uint16_t number = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number, 16);
  if (text.size() != 4 || read.ec != std::errc() || read.ptr != end)
    throw std::invalid_argument(
        fmt::format("{} = \"{}\": four hexadecimal digits are needed, e.g. \"1209\"", what, text));
  return number;
}

const AttachedDevice& selected(const DeviceSelection& selection,
                               std::span<const AttachedDevice> attached) {
  std::vector<AttachedDevice> fitting;
  const AttachedDevice* found = nullptr;
  for (const AttachedDevice& device : attached) {
    if (!selection.fits(device)) continue;
    fitting.push_back(device);
    found = &device;
  }
  if (found == nullptr) none_found(selection, attached);
  if (fitting.size() > 1)
    throw std::runtime_error(
        fmt::format("{} HID devices are {}: say which by serial, or by path:{}", fitting.size(),
                    selection.text(), list_of(fitting)));
  return *found;
}

}  // namespace trocar::hid
