// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid_device_parameters.hpp"

#include "components/devices/hid/hidapi_link.hpp"
#include "components/devices/hid/pipe_link.hpp"

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
  const hid::DeviceSelection selection{.vendor = number(vendor),
                                       .product = number(product),
                                       .serial = text(serial),
                                       .path = text(path)};
  if (!selection.path.empty() && !selection.path.starts_with("/dev/"))
    return std::make_unique<hid::SocketSource>(selection.path);
  return std::make_unique<hid::HidapiSource>(selection);
}

}  // namespace trocar
