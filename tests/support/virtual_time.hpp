// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>

#include "framework/time_source.hpp"

namespace trocar::test {

/// Time that moves when the test says so: a sleep ends `wake_up()` late, work takes what spend()
/// says, and looking at the time takes `look_ns`.
class VirtualTime final : public TimeSource {
 public:
  std::int64_t now() RT_SAFE override { return now_ns += look_ns; }
  void sleep_until(std::int64_t date_ns) RT_SAFE override {
    ++sleeps;
    now_ns = std::max(now_ns, date_ns + wake_up());
  }
  void spend(std::int64_t nanoseconds) { now_ns += nanoseconds; }

  std::int64_t now_ns = 0;
  std::int64_t look_ns = 0;  // more than 0 where the clock spins
  std::function<std::int64_t()> wake_up = [] { return std::int64_t{0}; };  // [ns]
  int sleeps = 0;
};

}  // namespace trocar::test
