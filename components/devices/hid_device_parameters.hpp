// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "components/devices/hid/link.hpp"
#include "framework/parameter_set.hpp"

namespace trocar {

/// Which HID device is meant.
struct HidDeviceParameters {
  explicit HidDeviceParameters(ParameterSet* set) : owner(set) {}
  /// @throw std::invalid_argument for a vendor or product that is no number
  std::unique_ptr<hid::LinkSource> source() const;

  ParameterSet* owner;
  Parameter<std::string> vendor{
      owner,
      "vendor",
      {.initial = "\"1209\"", .doc = "of USB, four hexadecimal digits, or \"any\""}};
  Parameter<std::string> product{
      owner,
      "product",
      {.initial = "\"0001\"", .doc = "of USB, four hexadecimal digits, or \"any\""}};
  Parameter<std::string> serial{
      owner, "serial", {.initial = "any", .doc = "of USB, where several are attached"}};
  Parameter<std::string> path{
      owner,
      "path",
      {.initial = "any",
       .doc = "\"/dev/hidraw3\", or the socket of an emulated device; decides alone"}};
};

}  // namespace trocar
