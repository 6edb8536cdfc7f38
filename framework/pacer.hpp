// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// Something outside whose beats may begin the ticks of a loop: a device that sends reports.
class Pacer {
 public:
  struct Beat {
    std::int64_t own_ns = 0;   // on its own clock, which may start anew
    std::int64_t date_ns = 0;  // when it was here, on CLOCK_MONOTONIC
  };
  virtual ~Pacer() = default;
  /// Between two beats.
  virtual std::int64_t period_ns() const = 0;
  /// Waits for a beat that was not given yet; of several the newest is given.
  /// @return false when none came until the date
  virtual bool wait_for_beat(std::int64_t date_ns, Beat& beat) RT_SAFE = 0;
};

}  // namespace trocar
