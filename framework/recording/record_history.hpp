// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "framework/event.hpp"

namespace trocar {

/// The latest rows and events of a run, in memory that is taken once: a new record makes room for
/// itself by letting the oldest go. For one thread.
class RecordHistory {
 public:
  /// @param capacity [bytes]
  explicit RecordHistory(std::size_t capacity);

  /// What a record of `size` bytes takes [bytes]. A record at the end of the memory goes round it
  /// and may leave up to as much unused.
  static std::size_t taken_by(std::size_t size) { return sizeof(Head) + (size + 7) / 8 * 8; }

  /// @throw std::length_error for a record that takes more than half the capacity
  void push(std::uint32_t tag, std::span<const std::byte> record);

  /// Hands what is kept to `take(tag, bytes)`, the oldest first.
  /// @param from leaves out the first so many of all that were ever pushed
  template <typename Take>
  void for_each(std::uint64_t from, const Take& take) const {
    std::uint64_t number = pushed_ - kept_;
    for (std::uint64_t at = begin_; number < pushed_; ++number) {
      const Head head = head_at(at);
      if (number >= from) take(head.tag, bytes_at(at, head));
      at = behind(at, head);
    }
  }

  std::uint64_t pushed() const { return pushed_; }
  std::uint64_t kept() const { return kept_; }

 private:
  struct Head {
    std::uint32_t size = 0;
    std::uint32_t tag = 0;
  };
  std::size_t index(std::uint64_t position) const { return position % memory_.size(); }
  /// Where a record that takes `size` bytes begins that may not begin before `position`.
  std::uint64_t place_for(std::uint64_t position, std::size_t size) const {
    const std::size_t to_end = memory_.size() - index(position);
    return size > to_end ? position + to_end : position;
  }
  Head head_at(std::uint64_t& position) const;
  std::span<const std::byte> bytes_at(std::uint64_t position, const Head& head) const {
    return std::span(memory_).subspan(index(position) + sizeof(Head), head.size);
  }
  static std::uint64_t behind(std::uint64_t position, const Head& head) {
    return position + taken_by(head.size);
  }

  std::vector<std::byte> memory_;
  std::uint64_t begin_ = 0;  // [bytes] since the first record: the oldest that is kept
  std::uint64_t end_ = 0;    // behind the latest
  std::uint64_t pushed_ = 0;
  std::uint64_t kept_ = 0;
};

}  // namespace trocar
