// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "framework/realtime/rt_safe.hpp"
#include "framework/types.hpp"

namespace trocar {

/// The receiving end of a simulated device. What is sent in period k arrives n periods later,
/// unless its deadline has passed by then, and acts until the next arrives:
///
///   acts in period k:  command of period k - n
///
/// 8 ms after the last arrival the watchdog makes the effort zero.
class CommandReceiver {
 public:
  static constexpr std::int64_t patience_ns = 8'000'000;
  static constexpr int longest_delay = 2;  // commands are not valid for longer than 3 periods

  /// @param delay n [periods], 0 to longest_delay
  CommandReceiver(std::int64_t period_ns, int delay) : period_ns_(period_ns), delay_(delay) {}

  /// As if `effort` had been sent until now: it acts until what is sent from `period` on arrives.
  void start(std::int64_t period, const Joints& effort) RT_SAFE {
    sent_.fill({});
    effort_ = effort;
    last_arrival_ = period + delay_;
  }
  void send(std::int64_t period, const Joints& effort, std::int64_t deadline_ns) RT_SAFE {
    sent_[slot(period)] = {period, deadline_ns, effort};
  }
  /// Takes what arrives at the beginning of a period.
  void begin(std::int64_t period) RT_SAFE {
    const Command& command = sent_[slot(period - delay_)];
    if (command.period != period - delay_ || period * period_ns_ > command.deadline_ns) return;
    effort_ = command.effort;
    last_arrival_ = period;
  }
  const Joints& effort() const RT_SAFE { return effort_; }  // [N, N m]

  /// How long effort() acts in the period before the watchdog ends it [ns].
  std::int64_t acts_for(std::int64_t period) const RT_SAFE {
    const std::int64_t left = (last_arrival_ - period) * period_ns_ + patience_ns;
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

  std::int64_t period_ns_;
  int delay_;
  std::array<Command, 4> sent_{};
  Joints effort_{};
  std::int64_t last_arrival_ = 0;
};

}  // namespace trocar
