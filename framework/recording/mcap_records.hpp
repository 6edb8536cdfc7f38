// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "framework/recording/mcap_format.hpp"

namespace trocar {

/// Damage in a log: which file, at which byte, what is wrong.
class McapError : public std::runtime_error {
 public:
  McapError(const std::string& file, std::uint64_t offset, const std::string& what)
      : std::runtime_error(file + ": at byte " + std::to_string(offset) + ": " + what),
        offset_(offset) {}
  std::uint64_t offset() const { return offset_; }  // [B] from the file's start

 private:
  std::uint64_t offset_;
};

struct McapSchema {
  std::uint16_t id = 0;
  std::string name, encoding, data;
  bool operator==(const McapSchema&) const = default;
};

struct McapChannel {
  std::uint16_t id = 0, schema_id = 0;  // schema 0: none
  std::string topic, message_encoding;
  mcap::Metadata metadata;
  bool operator==(const McapChannel&) const = default;
};

struct McapMessage {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time_ns = 0, publish_time_ns = 0;
  std::span<const std::byte> payload;  // valid during the callback only
};

struct McapAttachment {
  std::string name, media_type;
  std::uint64_t log_time_ns = 0, create_time_ns = 0;
  std::uint64_t size = 0;    // of the data [B]
  std::uint64_t offset = 0;  // of the record in the file [B]
  std::uint64_t length = 0;  // of the record [B]
};

struct McapMetadata {
  std::string name;
  mcap::Metadata entries;
};

namespace mcap {

/// Takes the format's types from bytes of unknown origin; each length is held
/// against what is left before it is used.
class Cursor {
 public:
  /// @param offset where `bytes` lie in the file, for messages
  Cursor(const std::string& file, std::uint64_t offset, std::span<const std::byte> bytes)
      : file_(&file), offset_(offset), bytes_(bytes) {}

  template <typename Number>
  Number number() {
    Number value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view string();
  Metadata map();
  /// The next `size` bytes. @throw McapError when there are fewer.
  std::span<const std::byte> take(std::uint64_t size);

  std::uint64_t offset() const { return offset_; }
  std::uint64_t left() const { return bytes_.size(); }
  [[noreturn]] void fail(const std::string& what) const { throw McapError(*file_, offset_, what); }

 private:
  const std::string* file_;
  std::uint64_t offset_;
  std::span<const std::byte> bytes_;
};

struct Record {
  Op op{};
  std::uint64_t offset = 0;  // of its operation code in the file [B]
  std::uint64_t length = 0;  // of its content [B]
  std::uint64_t content() const { return offset + record_head; }
  std::uint64_t end() const { return content() + length; }
};

struct ChunkHead {
  std::uint64_t first_ns = 0, last_ns = 0;
  std::uint32_t crc = 0;
  std::uint64_t records_size = 0;  // [B]
};

struct Statistics {
  std::uint64_t message_count = 0;
  std::uint32_t attachment_count = 0, metadata_count = 0, chunk_count = 0;
  std::uint64_t first_ns = 0, last_ns = 0;
  std::map<std::uint16_t, std::uint64_t> channel_counts;
};

struct Footer {
  std::uint64_t summary_start = 0;
  std::uint32_t summary_crc = 0;
};

/// Head and extent of the next record; the cursor moves to its content.
Record parse_record(Cursor& cursor);
McapSchema parse_schema(Cursor cursor);
McapChannel parse_channel(Cursor cursor);
McapMessage parse_message(Cursor cursor);
McapMetadata parse_metadata(Cursor cursor);
McapAttachment parse_attachment_index(Cursor cursor);
/// All but the data and the checksum; the cursor moves to the data.
McapAttachment parse_attachment_head(Cursor& cursor, const Record& record);
/// @throw McapError also for a compressed chunk: neither writer nor reader knows one.
ChunkHead parse_chunk_head(Cursor& cursor);
Statistics parse_statistics(Cursor cursor);
Footer parse_footer(Cursor cursor);

}  // namespace mcap
}  // namespace trocar
