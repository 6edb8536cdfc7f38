// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// A slot of the loop's time raster: slot k is due k periods after the start.
struct Slot {
  std::int64_t index = 0;
  std::int64_t lateness_ns = 0;  // of the tick's beginning, to the slot itself
  std::int64_t skipped = 0;      // slots before it that nobody used
};

/// What paces the loop.
class Clock {
 public:
  virtual ~Clock() = default;
  /// Slot 0 is due now.
  virtual void start(std::int64_t period_ns) = 0;
  /// Waits for the next slot. A slot that is over is skipped: with motors there is no catching up.
  virtual Slot wait() RT_SAFE = 0;
  /// Virtual time has no dates, no lateness and no hurry: it waits for readers that fall behind.
  virtual bool simulated() const = 0;
};

/// Absolute deadlines of CLOCK_MONOTONIC.
class PeriodicClock final : public Clock {
 public:
  void start(std::int64_t period_ns) override;
  Slot wait() RT_SAFE override;
  bool simulated() const override { return false; }

 private:
  std::int64_t period_ns_ = 0;
  std::int64_t start_ns_ = 0;
  std::int64_t next_ = 0;
};

/// Time is slot × period, as fast as the machine goes; two runs are alike to the bit.
class SimulatedClock final : public Clock {
 public:
  void start(std::int64_t) override { next_ = 0; }
  Slot wait() RT_SAFE override { return {next_++, 0, 0}; }
  bool simulated() const override { return true; }

 private:
  std::int64_t next_ = 0;
};

/// [ns] of CLOCK_MONOTONIC.
std::int64_t monotonic_ns() RT_SAFE;

}  // namespace trocar
