// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// A bounded queue between one writer and one reader, both wait-free.
template <typename T, std::size_t Capacity>
class SpscQueue {
  static_assert(std::is_trivially_copyable_v<T> && (Capacity & (Capacity - 1)) == 0);

 public:
  /// False when it is full.
  bool try_push(const T& value) RT_SAFE {
    const std::size_t written = written_.load(std::memory_order_relaxed);
    if (written - read_.load(std::memory_order_acquire) == Capacity) return false;
    slots_[written % Capacity] = value;
    written_.store(written + 1, std::memory_order_release);
    return true;
  }
  std::optional<T> try_pop() RT_SAFE {
    const std::size_t read = read_.load(std::memory_order_relaxed);
    if (read == written_.load(std::memory_order_acquire)) return std::nullopt;
    const T value = slots_[read % Capacity];
    read_.store(read + 1, std::memory_order_release);
    return value;
  }

 private:
  std::array<T, Capacity> slots_{};
  alignas(64) std::atomic<std::size_t> written_{0};
  alignas(64) std::atomic<std::size_t> read_{0};
};

}  // namespace trocar
