// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/link_sources.hpp"

#include "components/devices/hid/hidapi_link.hpp"
#include "components/devices/hid/pipe_link.hpp"

namespace trocar::hid {

std::unique_ptr<LinkSource> source_of(const DeviceSelection& selection) {
  if (!selection.path.empty() && !selection.path.starts_with("/dev/"))
    return std::make_unique<SocketSource>(selection.path);
  return std::make_unique<HidapiSource>(selection);
}

}  // namespace trocar::hid
