// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <vector>

/// @file
/// The encoding `cdr` of ROS 2 messages, little-endian: four bytes 00 01 00 00, then
/// the fields in order, each number aligned to its size counted from the fifth byte
/// (OMG CORBA 3.4, part 2, section 9.3; DDSI-RTPS 2.5, section 10).

namespace trocar {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie");

inline constexpr std::size_t cdr_head = 4;  // [B]

/// Where a number of `size` bytes lies when the bytes before end at `offset`
/// (both from the message's first byte).
constexpr std::size_t cdr_align(std::size_t offset, std::size_t size) {
  const std::size_t past = (offset - cdr_head) % size;
  return past == 0 ? offset : offset + size - past;
}

/// Appends fields to a buffer that keeps its memory from message to message.
class CdrWriter {
 public:
  /// Empties `into` and writes the four bytes.
  explicit CdrWriter(std::vector<std::byte>& into);

  template <typename Number>
  void number(Number value) {
    static_assert(std::is_arithmetic_v<Number> && sizeof value <= 8);
    append(&value, sizeof value, sizeof value);
  }
  void boolean(bool value) { number(static_cast<std::uint8_t>(value)); }
  void string(std::string_view text);

 private:
  void append(const void* data, std::size_t size, std::size_t alignment);

  std::vector<std::byte>* bytes_;
};

/// Takes fields from bytes of unknown origin.
class CdrReader {
 public:
  /// @throw std::runtime_error when the bytes do not begin with 00 01.
  /// @param offset of the first field to read, from the first byte
  explicit CdrReader(std::span<const std::byte> bytes, std::size_t offset = cdr_head);

  // Each throws std::runtime_error when too few bytes are left.

  template <typename Number>
  Number number() {
    static_assert(std::is_arithmetic_v<Number> && sizeof(Number) <= 8);
    Number value;
    std::memcpy(&value, take(sizeof value, sizeof value), sizeof value);
    return value;
  }
  bool boolean() { return number<std::uint8_t>() != 0; }
  std::string_view string();  // valid as long as the bytes are

  std::size_t offset() const { return offset_; }
  std::size_t left() const { return bytes_.size() - std::min(offset_, bytes_.size()); }

 private:
  const std::byte* take(std::size_t size, std::size_t alignment);

  std::span<const std::byte> bytes_;
  std::size_t offset_;
};

}  // namespace trocar
