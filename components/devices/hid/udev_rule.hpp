// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace trocar::hid {

/// Of USB: a number for tests, not one of ours.
inline constexpr std::uint16_t laparoscope_vendor = 0x1209, laparoscope_product = 0x0001;

/// "*:1209:0001.*": what udev calls such devices, on USB and of uhid alike.
std::string udev_key(std::uint16_t vendor, std::uint16_t product);

/// A line for udev that lets whoever sits at the machine, and the group plugdev, open a device.
std::string udev_rule(std::uint16_t vendor, std::uint16_t product);

/// The laparoscope's file of rules, 70-trocar.rules.
std::string udev_rules();

}  // namespace trocar::hid
