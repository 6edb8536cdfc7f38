// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstring>

#include "framework/recording/crc32.hpp"
#include "framework/recording/mcap_reader.hpp"

// How McapReader gets at records: by the summary, or by a scan of the data section.

namespace trocar {

using mcap::Cursor;
using mcap::Op;
using mcap::Record;

Record McapReader::record_at(std::uint64_t offset, std::uint64_t end) const {
  if (offset > end || end - offset < mcap::record_head)
    throw McapError(file_.path(), offset, "the file ends where a record should begin");
  std::array<std::byte, mcap::record_head> head{};
  file_.read(offset, head);
  Cursor cursor(file_.path(), offset, head);
  const Record record = mcap::parse_record(cursor);
  if (record.length > end - record.content())
    throw McapError(file_.path(), offset,
                    "a record of " + std::to_string(record.length) + " bytes begins here, but " +
                        std::to_string(end - record.content()) + " are left");
  return record;
}

Cursor McapReader::content_of(const Record& record, std::vector<std::byte>& buffer,
                              std::uint64_t size) const {
  if (size > record.length)
    throw McapError(file_.path(), record.offset, "the record is too short for its kind");
  buffer.resize(static_cast<std::size_t>(size));
  file_.read(record.content(), buffer);
  return {file_.path(), record.content(), buffer};
}

Cursor McapReader::whole_content_of(const Record& record, std::vector<std::byte>& buffer) const {
  if (record.length > limits_.record)
    throw McapError(file_.path(), record.offset,
                    "the record has " + std::to_string(record.length) + " bytes, the limit is " +
                        std::to_string(limits_.record));
  return content_of(record, buffer, record.length);
}

Cursor McapReader::chunk_records(const Record& record, std::vector<std::byte>& buffer) const {
  Cursor cursor = whole_content_of(record, buffer);
  const mcap::ChunkHead head = mcap::parse_chunk_head(cursor);
  const std::uint64_t start = cursor.offset();
  const auto records = cursor.take(head.records_size);
  if (head.crc != 0 && head.crc != crc32(records))
    throw McapError(file_.path(), record.offset, "the checksum of the chunk is wrong");
  return {file_.path(), start, records};
}

void McapReader::for_each_inside(Cursor records, const RecordVisitor& visit) const {
  while (records.left() > 0) {
    const Record record = mcap::parse_record(records);
    visit(record, Cursor(file_.path(), record.content(), records.take(record.length)));
  }
}

std::optional<std::string> McapReader::read_summary() {
  constexpr std::uint64_t tail = mcap::record_head + mcap::footer_content + mcap::magic.size();
  const std::string cut = "the file does not end as an MCAP file: it was cut off or not closed";
  if (file_.size() < mcap::magic.size() + tail) return cut;
  std::array<std::byte, tail> bytes{};
  file_.read(file_.size() - tail, bytes);
  if (std::memcmp(&bytes[tail - mcap::magic.size()], mcap::magic.data(), mcap::magic.size()) != 0)
    return cut;
  try {
    Cursor cursor(file_.path(), file_.size() - tail, bytes);
    const Record footer = mcap::parse_record(cursor);
    if (footer.op != Op::footer || footer.length != mcap::footer_content)
      return "the footer is damaged";
    const auto [start, crc] = mcap::parse_footer(cursor);
    if (start == 0) return "";  // an MCAP file may do without a summary
    if (start < mcap::magic.size() || start > footer.offset) return "the footer is damaged";
    const std::uint64_t size = footer.offset - start;
    if (size > limits_.listing) return "the summary is larger than the limit";
    std::vector<std::byte> summary(static_cast<std::size_t>(size));
    file_.read(start, summary);
    constexpr std::size_t footer_part = mcap::record_head + mcap::footer_content - sizeof crc;
    if (crc != 0 && crc != crc32(std::span(bytes).first(footer_part), crc32(summary)))
      return "the checksum of the summary is wrong";
    read_header();
    apply_summary(start, summary);
    // Without counts the data must be read to be described.
    if (statistics_.message_count == 0 || !statistics_.channel_counts.empty()) return {};
  } catch (const McapError& error) {
    return error.what();
  }
  return "";
}

void McapReader::apply_summary(std::uint64_t start, std::span<const std::byte> records) {
  bool counted = false;
  std::uint64_t metadata_end = 0;
  for_each_inside(Cursor(file_.path(), start, records), [&](const Record& record, Cursor content) {
    if (record.op == Op::schema) define(mcap::parse_schema(content), record.offset, record.length);
    if (record.op == Op::channel)
      define(mcap::parse_channel(content), record.offset, record.length);
    if (record.op == Op::attachment_index) {
      attachments_.push_back(mcap::parse_attachment_index(content));
      retain(record.offset, record.length);
    }
    if (record.op == Op::statistics) {
      statistics_ = mcap::parse_statistics(content);
      counted = true;
    }
    if (record.op != Op::metadata_index) return;
    const Record target = record_at(content.number<std::uint64_t>(), start);
    // Ascending places: no index can make the same record be read again and again.
    if (target.op != Op::metadata || target.offset < metadata_end)
      content.fail("the index names no metadata record");
    metadata_end = target.end();
    scan_record(target);
  });
  if (!counted) throw McapError(file_.path(), start, "the summary has no statistics");
  data_end_ = start;
}

void McapReader::read_header() {
  const Record record = record_at(mcap::magic.size(), file_.size());
  if (record.op != Op::header)
    throw McapError(file_.path(), record.offset, "a header should stand here");
  std::vector<std::byte> buffer;
  Cursor cursor = whole_content_of(record, buffer);
  profile_ = cursor.string();
  library_ = cursor.string();
}

void McapReader::scan() {
  schemas_.clear();
  channels_.clear();
  attachments_.clear();
  metadata_.clear();
  statistics_ = {};
  retained_ = 0;
  const std::uint64_t size = file_.size();
  data_end_ = mcap::magic.size();
  read_header();
  while (true) {
    const Record record = record_at(data_end_, size);
    if (record.op == Op::data_end || is_last(record)) return;
    const mcap::Statistics whole = statistics_;
    try {
      scan_record(record);
    } catch (const McapError&) {
      statistics_ = whole;  // messages() will not deliver a part of a record
      throw;
    }
    data_end_ = record.end();
  }
}

void McapReader::scan_record(const Record& record) {
  std::vector<std::byte> buffer;
  const auto note = [&](const Record& inner, const Cursor& content) {
    if (inner.op == Op::schema) define(mcap::parse_schema(content), inner.offset, inner.length);
    if (inner.op == Op::channel) define(mcap::parse_channel(content), inner.offset, inner.length);
    if (inner.op == Op::message) count(mcap::parse_message(content), inner.offset);
  };
  switch (record.op) {
    case Op::chunk:
      for_each_inside(chunk_records(record, buffer), note);
      ++statistics_.chunk_count;
      break;
    case Op::schema:
    case Op::channel:
    case Op::message:
      note(record, whole_content_of(record, buffer));
      break;
    case Op::attachment:
      attachments_.push_back(attachment_head(record));
      retain(record.offset,
             attachments_.back().name.size() + attachments_.back().media_type.size());
      break;
    case Op::metadata:
      metadata_.push_back(mcap::parse_metadata(whole_content_of(record, buffer)));
      retain(record.offset, record.length);
      break;
    default:
      break;  // indexes, and kinds that later versions add
  }
}

bool McapReader::is_last(const Record& record) const {
  if (record.op != Op::footer) return false;
  if (record.end() + mcap::magic.size() == file_.size()) return true;
  throw McapError(file_.path(), record.offset, "a footer stands before the file's end");
}

McapAttachment McapReader::attachment_head(const Record& record) const {
  // Two times, two strings of at most 64 KiB, the data's size.
  constexpr std::uint64_t enough = 2 * 8 + 2 * (4 + 65536) + 8;
  std::vector<std::byte> buffer;
  Cursor cursor = content_of(record, buffer, std::min(record.length, enough));
  return mcap::parse_attachment_head(cursor, record);
}

void McapReader::define(const McapSchema& schema, std::uint64_t offset, std::uint64_t size) {
  const auto [place, is_new] = schemas_.try_emplace(schema.id, schema);
  if (is_new) return retain(offset, size);
  if (place->second != schema)
    throw McapError(file_.path(), offset,
                    "schema " + std::to_string(schema.id) + " is defined twice, differently");
}

void McapReader::define(const McapChannel& channel, std::uint64_t offset, std::uint64_t size) {
  if (channel.schema_id != 0 && !schemas_.contains(channel.schema_id))
    throw McapError(file_.path(), offset,
                    "channel '" + channel.topic + "' names schema " +
                        std::to_string(channel.schema_id) + ", which is not there");
  const auto [place, is_new] = channels_.try_emplace(channel.id, channel);
  if (is_new) return retain(offset, size);
  if (place->second != channel)
    throw McapError(file_.path(), offset,
                    "channel " + std::to_string(channel.id) + " is defined twice, differently");
}

void McapReader::require_known(const McapMessage& message, std::uint64_t offset) const {
  if (!channels_.contains(message.channel))
    throw McapError(file_.path(), offset,
                    "a message on channel " + std::to_string(message.channel) +
                        ", which is not defined before it");
}

void McapReader::count(const McapMessage& message, std::uint64_t offset) {
  require_known(message, offset);
  auto& [total, attachments, metadata, chunks, first, last, channels] = statistics_;
  first = total == 0 ? message.log_time_ns : std::min(first, message.log_time_ns);
  last = total == 0 ? message.log_time_ns : std::max(last, message.log_time_ns);
  ++total;
  ++channels[message.channel];
}

void McapReader::retain(std::uint64_t offset, std::uint64_t size) {
  constexpr std::uint64_t entry = 64;  // even an empty one takes memory
  retained_ += size + entry;
  if (retained_ > limits_.listing)
    throw McapError(file_.path(), offset,
                    "schemas, channels and indexes take more than the limit of " +
                        std::to_string(limits_.listing) + " bytes");
}

}  // namespace trocar
