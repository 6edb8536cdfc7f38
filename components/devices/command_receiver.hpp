// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "framework/realtime/rt_safe.hpp"
#include "framework/types.hpp"

namespace trocar {

/// The receiving end of a simulated device. What is sent at the beginning of period k arrives n
/// whole periods and a part of one later, unless its deadline has passed by then, and acts until
/// the next arrives:
///
///   acts from (k + n) T + part on:  command of period k         delay = n T + part
///
/// 8 ms after the last arrival the watchdog makes the effort zero.
class CommandReceiver {
 public:
  static constexpr std::int64_t patience_ns = 8'000'000;
  static constexpr double longest_delay = 2.0;  // commands are not valid for longer than 3 periods

  /// @param delay [periods], 0 to longest_delay, to the nanosecond
  CommandReceiver(std::int64_t period_ns, double delay)
      : period_ns_(period_ns),
        whole_(static_cast<std::int64_t>(std::floor(delay))),
        part_ns_(std::llround((delay - std::floor(delay)) * static_cast<double>(period_ns))) {
    if (part_ns_ < period_ns_) return;
    ++whole_;
    part_ns_ = 0;
  }

  /// As if `effort` had been sent until now: it acts until what is sent from `period` on arrives.
  void start(std::int64_t period, const Joints& effort) RT_SAFE {
    sent_.fill({});
    effort_ = effort;
    last_arrival_ns_ = (period + whole_) * period_ns_ + part_ns_;
  }
  void send(std::int64_t period, const Joints& effort, std::int64_t deadline_ns) RT_SAFE {
    sent_[slot(period)] = {period, deadline_ns, effort};
  }
  /// Takes what arrives at the beginning of a period.
  void begin(std::int64_t period) RT_SAFE {
    if (part_ns_ == 0) arrive(period);
  }
  /// Takes what arrives within a period, `arrives_after` its beginning.
  void arrive(std::int64_t period) RT_SAFE {
    const Command& command = sent_[slot(period - whole_)];
    const std::int64_t now_ns = period * period_ns_ + part_ns_;
    if (command.period != period - whole_ || now_ns > command.deadline_ns) return;
    effort_ = command.effort;
    last_arrival_ns_ = now_ns;
  }
  std::int64_t arrives_after() const RT_SAFE { return part_ns_; }  // [ns]
  const Joints& effort() const RT_SAFE { return effort_; }         // [N, N m]

  /// How far into the period effort() acts before the watchdog ends it [ns].
  std::int64_t acts_for(std::int64_t period) const RT_SAFE {
    const std::int64_t left = last_arrival_ns_ + patience_ns - period * period_ns_;
    return left < 0 ? 0 : left < period_ns_ ? left : period_ns_;
  }

 private:
  struct Command {
    std::int64_t period = std::numeric_limits<std::int64_t>::min();  // none
    std::int64_t deadline_ns = 0;
    Joints effort{};
  };
  static std::size_t slot(std::int64_t period) RT_SAFE {
    return static_cast<std::size_t>(period & 3);
  }

  std::int64_t period_ns_, whole_, part_ns_;
  std::array<Command, 4> sent_{};
  Joints effort_{};
  std::int64_t last_arrival_ns_ = 0;
};

}  // namespace trocar
