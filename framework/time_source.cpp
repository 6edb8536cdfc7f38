// SPDX-License-Identifier: Apache-2.0
#include "framework/time_source.hpp"

#include <cerrno>
#include <ctime>

namespace trocar {

std::int64_t monotonic_ns() RT_SAFE {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

std::int64_t MonotonicTime::now() RT_SAFE {
  return monotonic_ns();
}

void MonotonicTime::sleep_until(std::int64_t date_ns) RT_SAFE {
  const timespec deadline{date_ns / 1'000'000'000, date_ns % 1'000'000'000};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
  }
}

}  // namespace trocar
