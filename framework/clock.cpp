// SPDX-License-Identifier: Apache-2.0
#include "framework/clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace trocar {

std::string check_spin(std::int64_t spin_ns, std::int64_t period_ns) {
  if (spin_ns >= 0 && spin_ns < period_ns) return "";
  const auto us = [](std::int64_t ns) { return static_cast<double>(ns) * 1e-3; };
  return fmt::format(
      "a guard spin of {:.6g} µs at a period of {:.6g} µs: 0 (off) or more, and shorter than the "
      "period, is possible; take what the machine needs to wake up, some 50 to 100 µs",
      us(spin_ns), us(period_ns));
}

void PeriodicClock::start_at(std::int64_t start_ns, std::int64_t period_ns) {
  if (const std::string wrong = check_spin(spin_ns_, period_ns); !wrong.empty())
    throw std::invalid_argument(wrong);
  period_ns_ = period_ns;
  next_ = 0;
  spun_ns_ = 0;
  start_ns_ = start_ns;
}

Slot PeriodicClock::wait() RT_SAFE {
  std::int64_t now = time_.now();
  const std::int64_t behind = std::max<std::int64_t>(0, now - (start_ns_ + next_ * period_ns_));
  const std::int64_t skipped = behind / period_ns_;
  const std::int64_t index = next_ + skipped;
  const std::int64_t overrun = next_ > 0 ? behind : 0;  // nothing came before the first slot
  next_ = index + 1;
  const std::int64_t due = start_ns_ + index * period_ns_;
  if (now < due - spin_ns_) {
    time_.sleep_until(due - spin_ns_);
    now = time_.now();
  }
  if (now < due) now = spin_until(due);
  return {index, now - due, skipped, overrun, now};
}

std::int64_t PeriodicClock::spin_until(std::int64_t due) RT_SAFE {
  const std::int64_t begin = time_.now();
  std::int64_t now = begin;
  while (now < due) now = time_.now();
  spun_ns_ += now - begin;
  return now;
}

}  // namespace trocar
