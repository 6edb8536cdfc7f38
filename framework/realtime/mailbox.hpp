// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace trocar {

/// Things on their way from threads that may wait to one that looks now and then, in their order.
/// Locks, for a few moves: not for the loop.
template <typename T>
class Mailbox {
 public:
  explicit Mailbox(std::size_t capacity) : capacity_(capacity) {}

  /// @return false when it is full: nothing was put
  bool put(T thing) {
    const std::lock_guard lock(mutex_);
    if (things_.size() >= capacity_) return false;
    things_.push_back(std::move(thing));
    return true;
  }
  std::deque<T> take_all() {
    const std::lock_guard lock(mutex_);
    return std::exchange(things_, {});
  }

 private:
  std::mutex mutex_;
  const std::size_t capacity_;
  std::deque<T> things_;
};

}  // namespace trocar
