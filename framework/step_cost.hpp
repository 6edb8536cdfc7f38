// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// How many heap allocations the calling thread has made so far, by whoever counts them. Bounded.
using AllocationCount = std::uint64_t (*)();

/// What the steps of a component, or whole ticks, cost at most. The first one is apart: it meets
/// memory and code that nobody has touched before.
struct StepCost {
  std::int64_t first_ns = 0;
  std::int64_t worst_ns = 0;     // of all others
  std::int64_t worst_tick = -1;  // when that was; -1 before there was another
  std::uint64_t steps = 0;
  std::uint64_t allocations = 0;      // on the heap, the first step's included
  std::int64_t allocation_tick = -1;  // when there was one first; -1: never

  void add(std::int64_t tick, std::int64_t ns, std::uint64_t allocated) RT_SAFE {
    if (steps++ == 0) {
      first_ns = ns;
    } else if (worst_tick < 0 || ns > worst_ns) {
      worst_ns = ns;
      worst_tick = tick;
    }
    if (allocated == 0) return;
    if (allocations == 0) allocation_tick = tick;
    allocations += allocated;
  }
};

}  // namespace trocar
