// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid_device_parameters.hpp"

#include "components/devices/hid/link_sources.hpp"

namespace trocar {
namespace {

std::optional<std::uint16_t> number(const Parameter<std::string>& parameter) {
  if (*parameter == "any") return {};
  return hid::usb_number(*parameter, parameter.name());
}

std::string text(const Parameter<std::string>& parameter) {
  return *parameter == "any" ? std::string() : *parameter;
}

}  // namespace

std::unique_ptr<hid::LinkSource> HidDeviceParameters::source() const {
  return hid::source_of({.vendor = number(vendor),
                         .product = number(product),
                         .serial = text(serial),
                         .path = text(path)});
}

}  // namespace trocar
