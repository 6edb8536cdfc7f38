// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/latest_slot.hpp"

#include <algorithm>
#include <cstring>

namespace trocar {
namespace {

constexpr std::size_t word = sizeof(std::uint64_t);

}  // namespace

LatestSlot::LatestSlot(std::size_t size) : size_(size) {
  for (Place& place : place_)
    place.words = std::make_unique<std::atomic<std::uint64_t>[]>((size + word - 1) / word);
}

void LatestSlot::store(std::int64_t time, std::span<const std::byte> value) RT_SAFE {
  const std::uint64_t n = newest_.load(std::memory_order_relaxed) + 1;
  Place& place = place_[n % places];
  place.sequence.store(2 * n - 1, std::memory_order_relaxed);
  place.time.store(time, std::memory_order_release);
  for (std::size_t at = 0; at < size_; at += word) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, value.data() + at, std::min(word, size_ - at));
    place.words[at / word].store(bits, std::memory_order_release);
  }
  place.sequence.store(2 * n, std::memory_order_release);
  newest_.store(n, std::memory_order_release);
}

bool LatestSlot::copy(std::uint64_t n, std::int64_t before, std::span<std::byte> value,
                      bool& too_young) const RT_SAFE {
  const Place& place = place_[n % places];
  if (place.sequence.load(std::memory_order_acquire) != 2 * n) return false;
  too_young = place.time.load(std::memory_order_acquire) >= before;
  for (std::size_t at = 0; at < size_; at += word) {
    const std::uint64_t bits = place.words[at / word].load(std::memory_order_acquire);
    std::memcpy(value.data() + at, &bits, std::min(word, size_ - at));
  }
  return place.sequence.load(std::memory_order_relaxed) == 2 * n;
}

bool LatestSlot::load(std::int64_t before, std::span<std::byte> value) const RT_SAFE {
  for (int tries = 0; tries < most_tries; ++tries) {
    const std::uint64_t n = newest_.load(std::memory_order_acquire);
    if (n == 0) return false;
    bool too_young = false;
    if (!copy(n, before, value, too_young)) continue;
    if (!too_young) return true;
    if (n == 1) return false;
    if (copy(n - 1, before, value, too_young)) return !too_young;
  }
  return false;
}

}  // namespace trocar
