// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// The sign of life of one loop to one thread that watches it. Wait-free on both sides.
class Heartbeat {
 public:
  /// By the loop, at the beginning of each tick.
  /// @return how long it was silent [ns] when the watcher gave it up meanwhile, else 0
  std::int64_t beat(std::int64_t now_ns) RT_SAFE {
    last_.store(now_ns, std::memory_order_release);
    if (given_up_.load(std::memory_order_relaxed) == none) return 0;
    return now_ns - given_up_.exchange(none, std::memory_order_acq_rel);
  }
  /// By the loop: there is nothing more to watch.
  void end() RT_SAFE { last_.store(over, std::memory_order_release); }
  bool begun() const RT_SAFE { return last_.load(std::memory_order_acquire) != none; }
  bool ended() const RT_SAFE { return last_.load(std::memory_order_acquire) == over; }

  /// By the watcher.
  /// @return whether the latest beat is older than `patience_ns`; once for each beat
  bool gives_up(std::int64_t now_ns, std::int64_t patience_ns) RT_SAFE {
    const std::int64_t last = last_.load(std::memory_order_acquire);
    if (last == none || last == over || last == judged_ || now_ns - last <= patience_ns)
      return false;
    judged_ = last;
    given_up_.store(last, std::memory_order_release);
    return true;
  }

 private:
  static constexpr std::int64_t none = 0;
  static constexpr std::int64_t over = std::numeric_limits<std::int64_t>::max();

  std::atomic<std::int64_t> last_{none};      // date of the latest beat [ns]
  std::atomic<std::int64_t> given_up_{none};  // the beat after which the watcher gave up
  std::int64_t judged_ = none;                // the watcher's own
  static_assert(std::atomic<std::int64_t>::is_always_lock_free);
};

}  // namespace trocar
