// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/realtime/exclusive.hpp"

namespace trocar::hid {

/// Around all that hidapi does without an open device: its state there is the process' own.
Exclusive& hidapi_lock();

}  // namespace trocar::hid
