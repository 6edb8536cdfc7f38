// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// Where a clock takes its time from, so that its rules can be tested in virtual time.
class TimeSource {
 public:
  virtual ~TimeSource() = default;
  /// [ns] since some moment; never goes back.
  virtual std::int64_t now() RT_SAFE = 0;
  /// Returns when now() has reached `date_ns`, usually some µs later.
  virtual void sleep_until(std::int64_t date_ns) RT_SAFE = 0;
};

/// CLOCK_MONOTONIC, waited for by clock_nanosleep with absolute dates.
class MonotonicTime final : public TimeSource {
 public:
  std::int64_t now() RT_SAFE override;
  void sleep_until(std::int64_t date_ns) RT_SAFE override;
};

/// [ns] of CLOCK_MONOTONIC.
std::int64_t monotonic_ns() RT_SAFE;

}  // namespace trocar
