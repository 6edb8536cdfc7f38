// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// What the MCAP writer and reader share: operation codes and little-endian bytes
/// (https://mcap.dev/spec, major version 0).

namespace trocar::mcap {

static_assert(std::endian::native == std::endian::little, "records are copied as they lie");

using Metadata = std::map<std::string, std::string>;

enum class Op : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

inline constexpr std::array<unsigned char, 8> magic = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t record_head = 1 + 8;        // operation code, content length [B]
inline constexpr std::size_t message_head = 2 + 4 + 16;  // channel, sequence, two times [B]
inline constexpr std::size_t footer_content = 8 + 8 + 4;

/// Appends the format's types to a growing buffer.
class Bytes {
 public:
  template <typename Number>
  void number(Number value) {
    static_assert(std::is_arithmetic_v<Number>);
    raw(&value, sizeof value);
  }
  void raw(const void* data, std::size_t size);
  /// @throw std::length_error above 4 GiB, which the format cannot express.
  void string(std::string_view text) {
    number(checked_length(text.size()));
    raw(text.data(), text.size());
  }
  void map(const Metadata& entries) {
    const std::size_t start = open_length32();
    for (const auto& [key, value] : entries) {
      string(key);
      string(value);
    }
    close_length32(start);
  }
  /// Reserves a 32-bit length that close_length32() fills in.
  std::size_t open_length32() {
    number(std::uint32_t{0});
    return bytes_.size();
  }
  void close_length32(std::size_t start) {
    const std::uint32_t length = checked_length(bytes_.size() - start);
    std::memcpy(bytes_.data() + start - sizeof length, &length, sizeof length);
  }
  /// Begins a record whose content length end_record() fills in.
  std::size_t begin_record(Op op) {
    number(static_cast<std::uint8_t>(op));
    number(std::uint64_t{0});
    return bytes_.size();
  }
  void end_record(std::size_t start) {
    const std::uint64_t length = bytes_.size() - start;
    std::memcpy(bytes_.data() + start - sizeof length, &length, sizeof length);
  }

  void clear() { bytes_.clear(); }
  std::size_t size() const { return bytes_.size(); }
  bool empty() const { return bytes_.empty(); }
  const std::byte* data() const { return bytes_.data(); }

 private:
  static std::uint32_t checked_length(std::size_t size) {
    if (size > std::numeric_limits<std::uint32_t>::max())
      throw std::length_error("MCAP: a string or map must be shorter than 4 GiB");
    return static_cast<std::uint32_t>(size);
  }

  std::vector<std::byte> bytes_;
};

}  // namespace trocar::mcap
