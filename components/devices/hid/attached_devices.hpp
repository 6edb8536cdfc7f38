// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trocar::hid {

/// A HID interface that is attached, as the system tells.
struct AttachedDevice {
  std::string path{};  // "/dev/hidraw3"
  std::uint16_t vendor = 0, product = 0;
  std::string serial{}, manufacturer{}, name{};
  std::uint16_t usage_page = 0;
  int interface = -1;  // of USB; -1 where the bus has none

  /// "/dev/hidraw3 1209:0001 Trocar laparoscope, serial 7"
  std::string text() const;
};

/// All of them, in the order of their paths. Needs no rights.
std::vector<AttachedDevice> attached_devices();

/// Which device is meant. What is not given fits any.
struct DeviceSelection {
  std::optional<std::uint16_t> vendor{}, product{};
  std::vector<std::uint16_t> or_products{};  // as good as `product`
  std::string serial{};
  std::string path{};  // alone decides, where it is given

  /// "1209:0001, serial 7"
  std::string text() const;
  bool fits(const AttachedDevice& device) const;
};

/// "1209", four hexadecimal digits. @throw std::invalid_argument with what is allowed
std::uint16_t usb_number(const std::string& text, const std::string& what);

/// The one that is meant.
/// @throw std::runtime_error when it is none, or one of several: says what was looked for, what is
/// attached, and which is nearest
const AttachedDevice& selected(const DeviceSelection& selection,
                               std::span<const AttachedDevice> attached);

}  // namespace trocar::hid
