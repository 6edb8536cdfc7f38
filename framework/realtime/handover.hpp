// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace trocar {

/// Gives something that cannot be copied from one thread to another. What was not taken is
/// replaced. Locks, for a few moves: not for the loop.
template <typename T>
class Handover {
 public:
  void put(T thing) {
    const std::lock_guard lock(mutex_);
    thing_ = std::move(thing);
  }
  std::optional<T> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(thing_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<T> thing_;
};

}  // namespace trocar
