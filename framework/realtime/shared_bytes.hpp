// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <mutex>
#include <span>
#include <vector>

namespace trocar {

/// The newest bytes of one ordinary thread for another one. They wait for each other, so neither
/// may be the loop's: for that there is LatestSlot.
class SharedBytes {
 public:
  void put(std::span<const std::byte> bytes) {
    const std::lock_guard lock(mutex_);
    bytes_.assign(bytes.begin(), bytes.end());
  }
  /// Empty before the first.
  std::vector<std::byte> get() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::byte> bytes_;
};

}  // namespace trocar
