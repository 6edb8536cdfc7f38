// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/mcap_writer.hpp"

#include <algorithm>
#include <stdexcept>

#include "framework/version.hpp"

namespace trocar {
namespace {

using mcap::Bytes;
using mcap::Op;

constexpr std::size_t max_ids = 0xFFFF;

std::span<const std::byte> span_of(const Bytes& bytes) {
  return {bytes.data(), bytes.size()};
}

[[noreturn]] void refuse(const std::string& text) {
  throw std::invalid_argument("MCAP: " + text);
}

}  // namespace

std::string McapWriter::default_library() {
  return "trocar " + version();
}

McapWriter::McapWriter(const std::string& path, Settings settings)
    : settings_(std::move(settings)), file_(path) {
  begin_file();
}

McapWriter::~McapWriter() {
  try {
    close();
  } catch (...) {
    // A destructor has nobody to tell; the chunks that were written stay readable.
  }
}

void McapWriter::begin_file() {
  scratch_.raw(mcap::magic.data(), mcap::magic.size());
  const std::size_t record = scratch_.begin_record(Op::header);
  scratch_.string(settings_.profile);
  scratch_.string(settings_.library);
  scratch_.end_record(record);
  file_.append({span_of(scratch_)});
}

std::uint16_t McapWriter::schema(std::string_view name, std::string_view encoding,
                                 std::string_view data) {
  if (name.empty()) refuse("a schema needs a name");
  if (schema_count_ == max_ids) refuse("a file holds at most 65535 schemas");
  const auto id = static_cast<std::uint16_t>(schema_count_ + 1);  // 0 means "no schema"
  scratch_.clear();
  const std::size_t record = scratch_.begin_record(Op::schema);
  scratch_.number(id);
  scratch_.string(name);
  scratch_.string(encoding);
  scratch_.string(data);
  scratch_.end_record(record);
  file_.append({span_of(scratch_)});
  schemas_.raw(scratch_.data(), scratch_.size());
  ++schema_count_;
  return id;
}

std::uint16_t McapWriter::channel(std::string_view topic, std::uint16_t schema_id,
                                  std::string_view message_encoding,
                                  const mcap::Metadata& metadata) {
  if (schema_id > schema_count_)
    refuse("channel '" + std::string(topic) + "' names schema " + std::to_string(schema_id) +
           ", but there are " + std::to_string(schema_count_) + "; call schema() first");
  if (channels_.size() > max_ids) refuse("a file holds at most 65536 channels");
  const auto id = static_cast<std::uint16_t>(channels_.size());
  scratch_.clear();
  const std::size_t record = scratch_.begin_record(Op::channel);
  scratch_.number(id);
  scratch_.number(schema_id);
  scratch_.string(topic);
  scratch_.string(message_encoding);
  scratch_.map(metadata);
  scratch_.end_record(record);
  file_.append({span_of(scratch_)});
  channel_records_.raw(scratch_.data(), scratch_.size());
  channels_.emplace_back();
  return id;
}

void McapWriter::TimeRange::include(std::uint64_t time, bool is_first) {
  first = is_first ? time : std::min(first, time);
  last = is_first ? time : std::max(last, time);
}

void McapWriter::message(std::uint16_t channel, std::uint32_t sequence, std::uint64_t log_time_ns,
                         std::uint64_t publish_time_ns, std::span<const std::byte> payload) {
  file_.require_good();
  if (channel >= channels_.size())
    refuse("message on channel " + std::to_string(channel) + ", but there are " +
           std::to_string(channels_.size()) + "; call channel() first");
  if (!chunk_.empty() && log_time_ns > chunk_first_ &&
      log_time_ns - chunk_first_ >= settings_.chunk_duration)
    close_chunk();
  if (chunk_.empty()) chunk_first_ = log_time_ns;
  chunk_time_.include(log_time_ns, chunk_.empty());
  file_time_.include(log_time_ns, message_count_ == 0);
  channels_[channel].index.emplace_back(log_time_ns, chunk_.size());
  const std::size_t record = chunk_.begin_record(Op::message);
  chunk_.number(channel);
  chunk_.number(sequence);
  chunk_.number(log_time_ns);
  chunk_.number(publish_time_ns);
  chunk_.raw(payload.data(), payload.size());
  chunk_.end_record(record);
  ++channels_[channel].count;
  ++message_count_;
  payload_bytes_ += payload.size();
  if (chunk_.size() >= settings_.chunk_size) close_chunk();
}

void McapWriter::attachment(std::string_view name, std::string_view media_type,
                            std::uint64_t log_time_ns, std::uint64_t create_time_ns,
                            std::span<const std::byte> data) {
  const std::uint64_t offset = file_.size();
  scratch_.clear();
  const std::size_t record = scratch_.begin_record(Op::attachment);
  scratch_.number(log_time_ns);
  scratch_.number(create_time_ns);
  scratch_.string(name);
  scratch_.string(media_type);
  scratch_.number(std::uint64_t{data.size()});
  scratch_.raw(data.data(), data.size());
  scratch_.number(crc32(span_of(scratch_).subspan(record)));
  scratch_.end_record(record);
  file_.append({span_of(scratch_)});

  const std::size_t index = attachment_indexes_.begin_record(Op::attachment_index);
  attachment_indexes_.number(offset);
  attachment_indexes_.number(std::uint64_t{scratch_.size()});
  attachment_indexes_.number(log_time_ns);
  attachment_indexes_.number(create_time_ns);
  attachment_indexes_.number(std::uint64_t{data.size()});
  attachment_indexes_.string(name);
  attachment_indexes_.string(media_type);
  attachment_indexes_.end_record(index);
  ++attachment_count_;
}

void McapWriter::metadata(std::string_view name, const mcap::Metadata& entries) {
  const std::uint64_t offset = file_.size();
  scratch_.clear();
  const std::size_t record = scratch_.begin_record(Op::metadata);
  scratch_.string(name);
  scratch_.map(entries);
  scratch_.end_record(record);
  file_.append({span_of(scratch_)});

  const std::size_t index = metadata_indexes_.begin_record(Op::metadata_index);
  metadata_indexes_.number(offset);
  metadata_indexes_.number(std::uint64_t{scratch_.size()});
  metadata_indexes_.string(name);
  metadata_indexes_.end_record(index);
  ++metadata_count_;
}

void McapWriter::flush() {
  file_.require_good();
  close_chunk();
}

void McapWriter::append_message_indexes(Bytes& after, std::uint64_t start, Bytes& offsets) {
  for (std::size_t id = 0; id < channels_.size(); ++id) {
    auto& index = channels_[id].index;
    if (index.empty()) continue;
    offsets.number(static_cast<std::uint16_t>(id));
    offsets.number(start + after.size());
    const std::size_t record = after.begin_record(Op::message_index);
    after.number(static_cast<std::uint16_t>(id));
    const std::size_t entries = after.open_length32();
    for (const auto& [time, offset] : index) {
      after.number(time);
      after.number(offset);
    }
    after.close_length32(entries);
    after.end_record(record);
    index.clear();
  }
}

void McapWriter::close_chunk() {
  if (chunk_.empty()) return;
  Bytes head;
  head.number(static_cast<std::uint8_t>(Op::chunk));
  constexpr std::uint64_t fields = 8 + 8 + 8 + 4 + 4 + 8;
  head.number(fields + chunk_.size());
  head.number(chunk_time_.first);
  head.number(chunk_time_.last);
  head.number(std::uint64_t{chunk_.size()});
  head.number(crc32(span_of(chunk_)));
  head.string("");  // not compressed
  head.number(std::uint64_t{chunk_.size()});

  const std::uint64_t chunk_start = file_.size();
  const std::uint64_t chunk_length = head.size() + chunk_.size();
  Bytes offsets;
  scratch_.clear();
  append_message_indexes(scratch_, chunk_start + chunk_length, offsets);
  const std::size_t chunk_bytes = chunk_.size();
  file_.append({span_of(head), span_of(chunk_), span_of(scratch_)});
  chunk_.clear();

  const std::size_t index = chunk_indexes_.begin_record(Op::chunk_index);
  chunk_indexes_.number(chunk_time_.first);
  chunk_indexes_.number(chunk_time_.last);
  chunk_indexes_.number(chunk_start);
  chunk_indexes_.number(chunk_length);
  const std::size_t map = chunk_indexes_.open_length32();
  chunk_indexes_.raw(offsets.data(), offsets.size());
  chunk_indexes_.close_length32(map);
  chunk_indexes_.number(std::uint64_t{scratch_.size()});
  chunk_indexes_.string("");
  chunk_indexes_.number(std::uint64_t{chunk_bytes});
  chunk_indexes_.number(std::uint64_t{chunk_bytes});
  chunk_indexes_.end_record(index);
  ++chunk_count_;
}

void McapWriter::append_statistics(Bytes& summary) const {
  const std::size_t record = summary.begin_record(Op::statistics);
  summary.number(message_count_);
  summary.number(static_cast<std::uint16_t>(schema_count_));
  summary.number(static_cast<std::uint32_t>(channels_.size()));
  summary.number(attachment_count_);
  summary.number(metadata_count_);
  summary.number(chunk_count_);
  summary.number(file_time_.first);
  summary.number(file_time_.last);
  const std::size_t map = summary.open_length32();
  for (std::size_t id = 0; id < channels_.size(); ++id) {
    summary.number(static_cast<std::uint16_t>(id));
    summary.number(channels_[id].count);
  }
  summary.close_length32(map);
  summary.end_record(record);
}

void McapWriter::append_summary() {
  Bytes end;
  const std::size_t data_end = end.begin_record(Op::data_end);
  end.number(file_.crc());
  end.end_record(data_end);

  const std::uint64_t summary_start = file_.size() + end.size();
  Bytes statistics, summary, offsets;
  append_statistics(statistics);
  const auto group = [&](Op op, const Bytes& records) {
    if (records.empty()) return;
    const std::size_t record = offsets.begin_record(Op::summary_offset);
    offsets.number(static_cast<std::uint8_t>(op));
    offsets.number(summary_start + summary.size());
    offsets.number(std::uint64_t{records.size()});
    offsets.end_record(record);
    summary.raw(records.data(), records.size());
  };
  group(Op::schema, schemas_);
  group(Op::channel, channel_records_);
  group(Op::statistics, statistics);
  group(Op::chunk_index, chunk_indexes_);
  group(Op::attachment_index, attachment_indexes_);
  group(Op::metadata_index, metadata_indexes_);

  const std::uint64_t offsets_start = summary_start + summary.size();
  summary.raw(offsets.data(), offsets.size());
  // The checksum covers the footer's own head, so its length must stand there before.
  summary.number(static_cast<std::uint8_t>(Op::footer));
  summary.number(std::uint64_t{mcap::footer_content});
  summary.number(summary_start);
  summary.number(offsets_start);
  summary.number(crc32(span_of(summary)));
  summary.raw(mcap::magic.data(), mcap::magic.size());
  file_.append({span_of(end), span_of(summary)});
}

void McapWriter::close() {
  if (closed_) return;
  closed_ = true;
  close_chunk();
  append_summary();
  file_.close();
}

std::uint64_t McapWriter::message_count(std::uint16_t channel) const {
  return channel < channels_.size() ? channels_[channel].count : 0;
}

}  // namespace trocar
