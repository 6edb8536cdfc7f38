// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/udev_rule.hpp"

#include <fmt/format.h>

namespace trocar::hid {

/// The name of the HID device above the hidraw node: BUS:VENDOR:PRODUCT.NUMBER.
std::string udev_key(std::uint16_t vendor, std::uint16_t product) {
  return fmt::format("*:{:04X}:{:04X}.*", vendor, product);
}

std::string udev_rule(std::uint16_t vendor, std::uint16_t product) {
  return fmt::format(
      "KERNEL==\"hidraw*\", KERNELS==\"{}\", MODE=\"0660\", GROUP=\"plugdev\", TAG+=\"uaccess\"",
      udev_key(vendor, product));
}

std::string udev_rules() {
  return "# Whoever sits at the machine, and the group plugdev, may open the laparoscope.\n" +
         udev_rule(laparoscope_vendor, laparoscope_product) + "\n";
}

}  // namespace trocar::hid
