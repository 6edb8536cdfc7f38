// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// The newest of dated values between one writer and any number of readers: a seqlock over four
/// places, each with a sequence number of its own.
///
/// The writer never waits. A reader takes the newest value that is whole: a writer that was
/// interrupted half-way holds nobody up, since the value before it still stands in its own place.
/// Only a writer that stores three more values while one is being copied makes a reader try again.
///
/// No torn value is ever returned. The writer marks a place as being written (odd number), then
/// stores each word with release; a reader loads each word with acquire and looks at the number
/// again. If any word was newer than the number that it saw first, that acquire made the new number
/// visible, and the copy is thrown away. (Words instead of fences: ThreadSanitizer understands
/// them.)
class LatestSlot {
 public:
  /// @param size [bytes] of a value
  explicit LatestSlot(std::size_t size);

  /// Wait-free. @param time of the value; grows from store to store
  void store(std::int64_t time, std::span<const std::byte> value) RT_SAFE;
  /// The newest value whose time is less than `before`; false, and `value` is not to be used, when
  /// there is none among the last two, or the writer was faster for `most_tries` times.
  bool load(std::int64_t before, std::span<std::byte> value) const RT_SAFE;

  static constexpr int most_tries = 16;

 private:
  static constexpr std::uint64_t places = 4;
  struct Place {
    std::atomic<std::uint64_t> sequence{0};  // 2 n: the n-th value is whole; odd: being written
    std::atomic<std::int64_t> time{0};
    std::unique_ptr<std::atomic<std::uint64_t>[]> words;
  };
  /// Copies the n-th value; false when it is overwritten. `too_young` when it is not older.
  bool copy(std::uint64_t n, std::int64_t before, std::span<std::byte> value,
            bool& too_young) const RT_SAFE;

  std::size_t size_;
  std::array<Place, places> place_;
  alignas(64) std::atomic<std::uint64_t> newest_{0};  // number of values stored
};

}  // namespace trocar
