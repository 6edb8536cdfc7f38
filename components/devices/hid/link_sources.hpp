// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "components/devices/hid/attached_devices.hpp"
#include "components/devices/hid/link.hpp"

namespace trocar::hid {

/// Where links to the selected device come from: hidapi, or the socket of an emulated device where
/// a path is given that is not below /dev.
std::unique_ptr<LinkSource> source_of(const DeviceSelection& selection);

}  // namespace trocar::hid
