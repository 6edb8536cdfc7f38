// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// Asks a loop to end. May be raised from a signal handler or any thread.
class StopFlag {
 public:
  void raise() RT_SAFE { raised_.store(true, std::memory_order_release); }
  bool raised() const RT_SAFE { return raised_.load(std::memory_order_acquire); }

 private:
  std::atomic<bool> raised_{false};
  static_assert(std::atomic<bool>::is_always_lock_free);
};

}  // namespace trocar
