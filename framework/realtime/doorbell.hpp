// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// One thread tells another that something is there, and that one may wait for it until a date.
/// Rings are counted, so that none is lost between a look and a wait. By Linux' futex.
class Doorbell {
 public:
  /// Costs a system call, and more where somebody waits.
  void ring();
  /// Waits until there were other than `seen` rings, or until a date of CLOCK_MONOTONIC.
  /// @return the number of rings, which wraps
  std::uint32_t wait(std::uint32_t seen, std::int64_t date_ns) RT_SAFE;

 private:
  std::atomic<std::uint32_t> rings_{0};
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free && sizeof(rings_) == 4);
};

}  // namespace trocar
