// SPDX-License-Identifier: Apache-2.0
#include "framework/clock.hpp"

#include <cerrno>
#include <ctime>

namespace trocar {

std::int64_t monotonic_ns() RT_SAFE {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

void PeriodicClock::start(std::int64_t period_ns) {
  period_ns_ = period_ns;
  start_ns_ = monotonic_ns();
  next_ = 0;
}

Slot PeriodicClock::wait() RT_SAFE {
  const std::int64_t behind = (monotonic_ns() - start_ns_) / period_ns_ - next_;
  const std::int64_t skipped = behind > 0 ? behind : 0;
  const std::int64_t index = next_ + skipped;
  next_ = index + 1;
  const std::int64_t due = start_ns_ + index * period_ns_;
  const timespec deadline{due / 1'000'000'000, due % 1'000'000'000};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
  }
  return {index, monotonic_ns() - due, skipped};
}

}  // namespace trocar
