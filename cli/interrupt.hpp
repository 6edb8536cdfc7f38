// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/realtime/stop_flag.hpp"

namespace trocar::cli {

/// From now on the first Ctrl-C (or SIGTERM) raises the flag, so that a run ends in order; a second
/// one kills.
const StopFlag& stop_on_interrupt();

}  // namespace trocar::cli
