// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/clock.hpp"
#include "framework/pacer.hpp"

namespace trocar {

/// Each beat of a pacer begins a tick, so that the loop works on a report as soon as it is there.
///
///   slot of a beat = slot of the one before + round(its own time since then / period)
///
/// The first tick has 20 ms to be begun by a beat that came after the start.
/// A beat that never came, or that came while the loop was busy, leaves its slot skipped. When none
/// has come for one and a half periods, the clock goes on by itself, a tick each period: gates and
/// heartbeat supervise, and the age of what they see grows. Between two ticks that were begun by
/// beats it is the pacer's time that passes, not the machine's.
class PacedClock final : public Clock {
 public:
  explicit PacedClock(Pacer& pacer) : PacedClock(pacer, machine_) {}
  PacedClock(Pacer& pacer, TimeSource& time) : pacer_(pacer), time_(time) {}
  PacedClock(const PacedClock&) = delete;
  PacedClock& operator=(const PacedClock&) = delete;

  /// @throw std::invalid_argument when the pacer has another period
  void start(std::int64_t period_ns) override;
  /// `lateness_ns` is since the beat came, `overrun_ns` since the next one was due.
  Slot wait() RT_SAFE override;
  bool simulated() const override { return false; }

 private:
  std::int64_t slot_of(const Pacer::Beat& beat) const RT_SAFE;

  MonotonicTime machine_;
  Pacer& pacer_;
  TimeSource& time_;
  std::int64_t period_ns_ = 0;
  std::int64_t next_ = 0;
  std::int64_t begun_ns_ = 0;  // when the last tick was due
  bool any_ = false;
  Pacer::Beat beat_{};          // the last one
  std::int64_t beat_slot_ = 0;  // that it began
};

}  // namespace trocar
