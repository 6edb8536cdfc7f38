// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/mcap_reader.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "framework/recording/crc32.hpp"

namespace trocar {

using mcap::Cursor;
using mcap::Op;
using mcap::Record;

McapReader::McapReader(const std::string& path, const Limits& limits)
    : file_(path), limits_(limits) {
  std::array<std::byte, mcap::magic.size()> start{};
  if (file_.size() >= start.size()) file_.read(0, start);
  if (std::memcmp(start.data(), mcap::magic.data(), start.size()) != 0)
    throw McapError(path, 0, "this is not an MCAP file (its first 8 bytes are not MCAP's)");
  data_end_ = file_.size();

  const std::optional<std::string> missing = read_summary();
  if (!missing) return;
  problem_ = *missing;
  try {
    scan();
  } catch (const McapError& error) {
    problem_ += (problem_.empty() ? "" : "; reading stopped early: ") + std::string(error.what());
  }
}

const McapChannel* McapReader::channel(std::string_view topic) const {
  for (const auto& [id, channel] : channels_)
    if (channel.topic == topic) return &channel;
  return nullptr;
}

std::uint64_t McapReader::message_count(std::uint16_t channel) const {
  const auto found = statistics_.channel_counts.find(channel);
  return found == statistics_.channel_counts.end() ? 0 : found->second;
}

bool McapReader::may_hold(const Record& chunk, const TimeRange& range) const {
  std::vector<std::byte> buffer;
  Cursor times = content_of(chunk, buffer, 2 * sizeof(std::uint64_t));
  const auto first = times.number<std::uint64_t>();
  const auto last = times.number<std::uint64_t>();
  return first <= range.last_ns && last >= range.first_ns;
}

std::uint64_t McapReader::data_begin() {
  return mcap::magic.size();
}

std::uint64_t McapReader::messages_at(std::uint64_t place, const MessageVisitor& visit,
                                      const TimeRange& range) const {
  const auto deliver = [&](const Record& record, const Cursor& content) {
    if (record.op != Op::message) return;
    const McapMessage message = mcap::parse_message(content);
    require_known(message, record.offset);
    if (message.log_time_ns >= range.first_ns && message.log_time_ns <= range.last_ns)
      visit(message);
  };
  const Record record = record_at(place, data_end_);
  if (record.op == Op::data_end) return data_end_;
  std::vector<std::byte> buffer;
  if (record.op == Op::chunk && may_hold(record, range))
    for_each_inside(chunk_records(record, buffer), deliver);
  if (record.op == Op::message) deliver(record, whole_content_of(record, buffer));
  return record.end();
}

void McapReader::messages(const MessageVisitor& visit, const TimeRange& range) const {
  for (std::uint64_t place = data_begin(); place < data_end_;)
    place = messages_at(place, visit, range);
}

std::vector<std::byte> McapReader::read(const McapAttachment& attachment) const {
  const Record record = record_at(attachment.offset, file_.size());
  if (record.op != Op::attachment || mcap::record_head + record.length != attachment.length)
    throw McapError(file_.path(), attachment.offset,
                    "attachment '" + attachment.name + "' is not where the index says");
  std::vector<std::byte> buffer;
  Cursor cursor = whole_content_of(record, buffer);
  const std::uint64_t size = mcap::parse_attachment_head(cursor, record).size;
  const auto data = cursor.take(size);
  const auto checked = std::span(buffer).first(buffer.size() - sizeof(std::uint32_t));
  const auto expected = cursor.number<std::uint32_t>();
  if (expected != 0 && expected != crc32(checked))
    cursor.fail("the checksum of attachment '" + attachment.name + "' is wrong");
  return {data.begin(), data.end()};
}

void McapReader::verify_data_crc(const Record& data_end) const {
  std::vector<std::byte> buffer;
  const auto expected = content_of(data_end, buffer, sizeof(std::uint32_t)).number<std::uint32_t>();
  if (expected == 0) return;  // "not available"
  std::uint32_t crc = 0;
  buffer.resize(std::size_t{1} << 16);
  for (std::uint64_t offset = 0; offset < data_end.offset;) {
    const auto piece = std::span(buffer).first(
        static_cast<std::size_t>(std::min<std::uint64_t>(buffer.size(), data_end.offset - offset)));
    file_.read(offset, piece);
    crc = crc32(piece, crc);
    offset += piece.size();
  }
  if (crc != expected)
    throw McapError(file_.path(), data_end.offset, "the checksum of the data section is wrong");
}

mcap::Statistics McapReader::count_records() const {
  mcap::Statistics found;
  std::uint64_t offset = mcap::magic.size();
  bool in_data = true;
  while (true) {
    const Record record = record_at(offset, file_.size());
    if (record.op == Op::data_end) verify_data_crc(record);
    if (is_last(record) && in_data)
      throw McapError(file_.path(), record.offset, "no record marks the end of the data");
    if (is_last(record)) return found;
    in_data = in_data && record.op != Op::data_end;
    found.attachment_count += in_data && record.op == Op::attachment;
    found.metadata_count += in_data && record.op == Op::metadata;
    found.chunk_count += in_data && record.op == Op::chunk;
    offset = record.end();
  }
}

void McapReader::verify() const {
  if (!complete()) throw McapError(file_.path(), data_end_, problem_);
  mcap::Statistics found = count_records();
  messages([&](const McapMessage& message) {
    ++found.message_count;
    ++found.channel_counts[message.channel];
  });
  for (const McapAttachment& attachment : attachments_) read(attachment);
  for (const auto& [channel, stated] : statistics_.channel_counts)
    if (stated != found.channel_counts[channel])
      throw McapError(file_.path(), data_end_,
                      "channel " + std::to_string(channel) + " has " +
                          std::to_string(found.channel_counts[channel]) +
                          " messages, the statistics say " + std::to_string(stated));
  if (found.message_count != statistics_.message_count ||
      found.attachment_count != attachments_.size() || found.metadata_count != metadata_.size() ||
      found.chunk_count != statistics_.chunk_count)
    throw McapError(file_.path(), data_end_, "the statistics do not match the records");
}

}  // namespace trocar
