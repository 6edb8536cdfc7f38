// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// A bounded queue of dated values of one size between one writer and one reader, both wait-free.
class SampleQueue {
 public:
  /// @param size [bytes] of a value  @param capacity values that fit
  SampleQueue(std::size_t size, std::size_t capacity)
      : size_(size), capacity_(capacity), times_(capacity), values_(capacity * size) {}

  /// False when it is full.
  bool try_push(std::int64_t time, std::span<const std::byte> value) RT_SAFE {
    const std::size_t written = written_.load(std::memory_order_relaxed);
    if (written - read_.load(std::memory_order_acquire) == capacity_) return false;
    times_[written % capacity_] = time;
    std::memcpy(&values_[written % capacity_ * size_], value.data(), size_);
    written_.store(written + 1, std::memory_order_release);
    return true;
  }

  /// The oldest value whose time is less than `before`; false when there is none.
  bool try_pop(std::int64_t before, std::span<std::byte> value) RT_SAFE {
    const std::size_t read = read_.load(std::memory_order_relaxed);
    if (read == written_.load(std::memory_order_acquire)) return false;
    if (times_[read % capacity_] >= before) return false;
    std::memcpy(value.data(), &values_[read % capacity_ * size_], size_);
    read_.store(read + 1, std::memory_order_release);
    return true;
  }

 private:
  std::size_t size_, capacity_;
  std::vector<std::int64_t> times_;
  std::vector<std::byte> values_;
  alignas(64) std::atomic<std::size_t> written_{0};
  alignas(64) std::atomic<std::size_t> read_{0};
};

}  // namespace trocar
