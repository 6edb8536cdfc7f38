// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "framework/realtime/rt_safe.hpp"
#include "framework/realtime/stop_flag.hpp"

namespace trocar {

/// A ring of records of any size between one writer and one reader; both wait-free. A record is
/// whole or not there: when it does not fit, try_begin() gives nothing and the writer decides. One
/// that with its head of 8 bytes is larger than half the ring never fits, nor does one of no bytes.
class RecordRing {
 public:
  /// @param capacity [bytes], rounded up to a power of two
  explicit RecordRing(std::size_t capacity);

  /// Room for a record of `size` bytes, contiguous, 8-aligned; empty when there is none.
  std::span<std::byte> try_begin(std::size_t size) RT_SAFE;
  /// The same, but waits until the reader has made room; for virtual time, which nobody is behind.
  /// Empty once the reader is gone, and at once for what never fits.
  std::span<std::byte> begin(std::size_t size);
  /// Hands over what try_begin() gave.
  void commit(std::uint32_t kind) RT_SAFE;

  struct Record {
    std::uint32_t kind = 0;
    std::span<const std::byte> bytes{};
  };
  /// The oldest record, or an empty span when there is none. Valid until pop().
  Record front() const RT_SAFE;
  void pop() RT_SAFE;
  /// The reader reads no more.
  void abandon() RT_SAFE { abandoned_.raise(); }

 private:
  struct Header {
    std::uint32_t size;  // of the record's bytes; `wrap` sends the reader to the start
    std::uint32_t kind;
  };
  static constexpr std::uint32_t wrap = 0xffffffff;
  static std::size_t padded(std::size_t size) { return sizeof(Header) + (size + 7) / 8 * 8; }
  /// A record at the end goes round it and leaves up to its own size unused.
  bool can_ever_fit(std::size_t size) const { return size > 0 && padded(size) <= capacity() / 2; }
  std::size_t index(std::size_t position) const { return position & (buffer_.size() * 8 - 1); }
  std::byte* at(std::size_t position) {
    return reinterpret_cast<std::byte*>(buffer_.data()) + index(position);
  }
  const std::byte* at(std::size_t position) const {
    return reinterpret_cast<const std::byte*>(buffer_.data()) + index(position);
  }
  std::size_t capacity() const { return buffer_.size() * 8; }

  std::vector<std::uint64_t> buffer_;
  alignas(64) std::atomic<std::size_t> written_{0};
  std::size_t begun_ = 0;  // the writer's: where the record that is being written starts
  std::uint32_t begun_size_ = 0;
  alignas(64) std::atomic<std::size_t> read_{0};
  StopFlag abandoned_;
};

}  // namespace trocar
