// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/mcap_records.hpp"

namespace trocar::mcap {

std::span<const std::byte> Cursor::take(std::uint64_t size) {
  if (size > bytes_.size())
    fail(std::to_string(size) + " bytes should follow, " + std::to_string(bytes_.size()) +
         " are left");
  const auto taken = bytes_.first(static_cast<std::size_t>(size));
  bytes_ = bytes_.subspan(static_cast<std::size_t>(size));
  offset_ += size;
  return taken;
}

std::string_view Cursor::string() {
  const auto bytes = take(number<std::uint32_t>());
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Metadata Cursor::map() {
  const auto length = number<std::uint32_t>();
  const std::uint64_t start = offset_;
  Cursor inner(*file_, start, take(length));
  Metadata entries;
  while (inner.left() > 0) {
    const std::string_view key = inner.string();
    if (!entries.emplace(key, inner.string()).second)
      inner.fail("key '" + std::string(key) + "' stands twice in a map");
  }
  return entries;
}

Record parse_record(Cursor& cursor) {
  Record record;
  record.offset = cursor.offset();
  record.op = static_cast<Op>(cursor.number<std::uint8_t>());
  record.length = cursor.number<std::uint64_t>();
  return record;
}

McapSchema parse_schema(Cursor cursor) {
  McapSchema schema;
  schema.id = cursor.number<std::uint16_t>();
  if (schema.id == 0) cursor.fail("a schema must not have the id 0");
  schema.name = cursor.string();
  schema.encoding = cursor.string();
  schema.data = cursor.string();
  return schema;
}

McapChannel parse_channel(Cursor cursor) {
  McapChannel channel;
  channel.id = cursor.number<std::uint16_t>();
  channel.schema_id = cursor.number<std::uint16_t>();
  channel.topic = cursor.string();
  channel.message_encoding = cursor.string();
  channel.metadata = cursor.map();
  return channel;
}

McapMessage parse_message(Cursor cursor) {
  McapMessage message;
  message.channel = cursor.number<std::uint16_t>();
  message.sequence = cursor.number<std::uint32_t>();
  message.log_time_ns = cursor.number<std::uint64_t>();
  message.publish_time_ns = cursor.number<std::uint64_t>();
  message.payload = cursor.take(cursor.left());
  return message;
}

McapMetadata parse_metadata(Cursor cursor) {
  McapMetadata metadata;
  metadata.name = cursor.string();
  metadata.entries = cursor.map();
  return metadata;
}

McapAttachment parse_attachment_index(Cursor cursor) {
  McapAttachment attachment;
  attachment.offset = cursor.number<std::uint64_t>();
  attachment.length = cursor.number<std::uint64_t>();
  attachment.log_time_ns = cursor.number<std::uint64_t>();
  attachment.create_time_ns = cursor.number<std::uint64_t>();
  attachment.size = cursor.number<std::uint64_t>();
  attachment.name = cursor.string();
  attachment.media_type = cursor.string();
  return attachment;
}

McapAttachment parse_attachment_head(Cursor& cursor, const Record& record) {
  McapAttachment attachment;
  attachment.offset = record.offset;
  attachment.length = record_head + record.length;
  attachment.log_time_ns = cursor.number<std::uint64_t>();
  attachment.create_time_ns = cursor.number<std::uint64_t>();
  attachment.name = cursor.string();
  attachment.media_type = cursor.string();
  attachment.size = cursor.number<std::uint64_t>();
  constexpr std::uint64_t crc_size = 4;
  const std::uint64_t left = record.end() - cursor.offset();
  if (left < crc_size || attachment.size != left - crc_size)
    cursor.fail("attachment '" + attachment.name + "' claims " + std::to_string(attachment.size) +
                " bytes of data, but its record has " + std::to_string(left) +
                " for data and checksum");
  return attachment;
}

ChunkHead parse_chunk_head(Cursor& cursor) {
  ChunkHead head;
  head.first_ns = cursor.number<std::uint64_t>();
  head.last_ns = cursor.number<std::uint64_t>();
  const auto size = cursor.number<std::uint64_t>();
  head.crc = cursor.number<std::uint32_t>();
  const std::string_view compression = cursor.string();
  if (!compression.empty())
    cursor.fail("the chunk is compressed with '" + std::string(compression.substr(0, 32)) +
                "'; only uncompressed chunks are read, so convert the file first: "
                "mcap compress --compression none");
  head.records_size = cursor.number<std::uint64_t>();
  if (size != head.records_size) cursor.fail("the chunk's two sizes differ");
  return head;
}

Statistics parse_statistics(Cursor cursor) {
  Statistics statistics;
  statistics.message_count = cursor.number<std::uint64_t>();
  cursor.number<std::uint16_t>();  // schemas and channels are counted from their records
  cursor.number<std::uint32_t>();
  statistics.attachment_count = cursor.number<std::uint32_t>();
  statistics.metadata_count = cursor.number<std::uint32_t>();
  statistics.chunk_count = cursor.number<std::uint32_t>();
  statistics.first_ns = cursor.number<std::uint64_t>();
  statistics.last_ns = cursor.number<std::uint64_t>();
  const auto length = cursor.number<std::uint32_t>();
  constexpr std::uint32_t entry_size = 2 + 8;
  if (length % entry_size != 0) cursor.fail("the message counts are not whole entries");
  for (std::uint32_t read = 0; read < length; read += entry_size) {
    const auto channel = cursor.number<std::uint16_t>();
    statistics.channel_counts[channel] = cursor.number<std::uint64_t>();
  }
  return statistics;
}

Footer parse_footer(Cursor cursor) {
  Footer footer;
  footer.summary_start = cursor.number<std::uint64_t>();
  cursor.number<std::uint64_t>();  // the summary's offsets are not needed
  footer.summary_crc = cursor.number<std::uint32_t>();
  return footer;
}

}  // namespace trocar::mcap
