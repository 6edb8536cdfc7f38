// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace trocar {

/// The present tick, as a component sees it.
struct Tick {
  std::int64_t index = 0;
  std::int64_t time_ns = 0;  // of the slot, since the run's start
  double time = 0.0;         // [s] the same
  double dt = 0.0;           // [s] since the component's last step, by the slots that passed,
                             // clamped to between half and twice its period
};

/// What a component may know when it is configured.
struct Setup {
  double period = 1e-3;       // [s] between two of its steps
  std::uint64_t seed = 0;     // its own: differs between components, the same in every run
  bool virtual_time = false;  // nothing may depend on a clock
  bool reloadable = false;    // parts of it may be replaced while it runs
};

}  // namespace trocar
