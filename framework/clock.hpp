// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "framework/time_source.hpp"

namespace trocar {

/// A slot of the loop's time raster: slot k is due k periods after the start.
struct Slot {
  std::int64_t index = 0;
  std::int64_t lateness_ns = 0;  // of the tick's beginning, to the slot itself
  std::int64_t skipped = 0;      // slots before it that nobody used
  std::int64_t overrun_ns = 0;   // how long the tick before went on after its next slot was due
  std::int64_t date_ns = 0;      // when its tick begins, on CLOCK_MONOTONIC; 0 in virtual time
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
  /// [ns] that were spent in busy-waiting since the start.
  virtual std::int64_t spun_ns() const { return 0; }
};

/// Absolute dates on a raster, so that nothing adds up: slot k is due at start + k · period,
/// however late earlier ones were, and the slots used and skipped are together the periods that
/// passed.
///
/// With a guard spin it sleeps until `spin` before the slot, and then looks at the time until the
/// slot: what the machine needs to wake up no longer makes the tick late, at the price of
/// spin / period of a processor at most.
class PeriodicClock final : public Clock {
 public:
  /// On the machine's monotonic time. @param spin_ns see check_spin
  explicit PeriodicClock(std::int64_t spin_ns = 0) : PeriodicClock(spin_ns, machine_) {}
  PeriodicClock(std::int64_t spin_ns, TimeSource& time) : spin_ns_(spin_ns), time_(time) {}
  PeriodicClock(const PeriodicClock&) = delete;
  PeriodicClock& operator=(const PeriodicClock&) = delete;

  /// @throw std::invalid_argument when the spin does not suit the period
  void start(std::int64_t period_ns) override { start_at(time_.now(), period_ns); }
  /// Slot 0 is due at a date of its source of time.
  /// @throw std::invalid_argument when the spin does not suit the period
  void start_at(std::int64_t start_ns, std::int64_t period_ns);
  Slot wait() RT_SAFE override;
  bool simulated() const override { return false; }
  std::int64_t spun_ns() const override { return spun_ns_; }

 private:
  std::int64_t spin_until(std::int64_t due) RT_SAFE;

  MonotonicTime machine_;
  std::int64_t spin_ns_;
  TimeSource& time_;
  std::int64_t period_ns_ = 0;
  std::int64_t start_ns_ = 0;
  std::int64_t next_ = 0;
  std::int64_t spun_ns_ = 0;
};

/// Time is slot × period, as fast as the machine goes; two runs are alike to the bit.
class SimulatedClock final : public Clock {
 public:
  void start(std::int64_t) override { next_ = 0; }
  Slot wait() RT_SAFE override { return {.index = next_++}; }
  bool simulated() const override { return true; }

 private:
  std::int64_t next_ = 0;
};

/// "" when a guard spin can be had at a period (0 <= spin < period), else what is wrong.
std::string check_spin(std::int64_t spin_ns, std::int64_t period_ns);

}  // namespace trocar
