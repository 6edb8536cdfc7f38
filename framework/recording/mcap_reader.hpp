// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "framework/recording/input_file.hpp"
#include "framework/recording/mcap_records.hpp"

namespace trocar {

/// Reads an MCAP file with uncompressed chunks (https://mcap.dev/spec).
///
/// What the summary tells is known at once. A file without a whole summary (cut
/// off, or its program killed) is scanned instead: everything up to the last whole
/// record is there, complete() is false and problem() says why.
/// Damaged or hostile input ends in an McapError; memory stays within the limits.
class McapReader {
 public:
  struct Limits {
    std::uint64_t record = std::uint64_t{256} << 20;   // largest chunk or attachment [B]
    std::uint64_t listing = std::uint64_t{256} << 20;  // summary, schemas, metadata in all [B]
  };
  struct TimeRange {
    std::uint64_t first_ns = 0;
    std::uint64_t last_ns = std::numeric_limits<std::uint64_t>::max();  // included
  };
  using MessageVisitor = std::function<void(const McapMessage&)>;

  /// @throw std::runtime_error when the file cannot be read,
  ///        McapError when it does not begin as an MCAP file.
  explicit McapReader(const std::string& path) : McapReader(path, Limits()) {}
  McapReader(const std::string& path, const Limits& limits);

  bool complete() const { return problem_.empty(); }
  const std::string& problem() const { return problem_; }  // empty when complete

  const std::string& profile() const { return profile_; }
  const std::string& library() const { return library_; }
  const std::map<std::uint16_t, McapSchema>& schemas() const { return schemas_; }
  const std::map<std::uint16_t, McapChannel>& channels() const { return channels_; }
  const std::vector<McapAttachment>& attachments() const { return attachments_; }
  const std::vector<McapMetadata>& metadata() const { return metadata_; }

  /// The first channel of that topic, or null.
  const McapChannel* channel(std::string_view topic) const;

  std::uint64_t message_count() const { return statistics_.message_count; }
  std::uint64_t message_count(std::uint16_t channel) const;
  std::uint64_t start_time_ns() const { return statistics_.first_ns; }  // 0 without messages
  std::uint64_t end_time_ns() const { return statistics_.last_ns; }
  std::uint64_t file_size() const { return file_.size(); }  // [B]

  /// Calls `visit` for each message in the file's order.
  /// @throw McapError at damage; the messages before that chunk were visited.
  void messages(const MessageVisitor& visit) const { messages(visit, TimeRange()); }
  /// Only those with a log time in `range`; other chunks are not even read.
  void messages(const MessageVisitor& visit, const TimeRange& range) const;

  /// The same by and by, for those who cannot wait: visits what the record at `place` holds, of a
  /// chunk all its messages. @param place data_begin() at first, then what the call before gave
  /// @return where the next record begins; data_end() when there is none
  std::uint64_t messages_at(std::uint64_t place, const MessageVisitor& visit,
                            const TimeRange& range) const;
  static std::uint64_t data_begin();
  std::uint64_t data_end() const { return data_end_; }

  /// An attachment's data. @throw McapError when its checksum or place is wrong.
  std::vector<std::byte> read(const McapAttachment& attachment) const;

  /// Reads the whole file and holds it against its checksums and its statistics.
  /// @throw McapError for the first thing that is wrong.
  void verify() const;

 private:
  using RecordVisitor = std::function<void(mcap::Record, mcap::Cursor)>;

  std::optional<std::string> read_summary();
  void apply_summary(std::uint64_t start, std::span<const std::byte> records);
  void read_header();
  void scan();
  void scan_record(const mcap::Record& record);
  void define(const McapSchema& schema, std::uint64_t offset, std::uint64_t size);
  void define(const McapChannel& channel, std::uint64_t offset, std::uint64_t size);
  void count(const McapMessage& message, std::uint64_t offset);
  void require_known(const McapMessage& message, std::uint64_t offset) const;
  void retain(std::uint64_t offset, std::uint64_t size);

  mcap::Record record_at(std::uint64_t offset, std::uint64_t end) const;
  mcap::Cursor content_of(const mcap::Record& record, std::vector<std::byte>& buffer,
                          std::uint64_t size) const;
  mcap::Cursor whole_content_of(const mcap::Record& record, std::vector<std::byte>& buffer) const;
  mcap::Cursor chunk_records(const mcap::Record& record, std::vector<std::byte>& buffer) const;
  bool is_last(const mcap::Record& record) const;
  bool may_hold(const mcap::Record& chunk, const TimeRange& range) const;
  void for_each_inside(mcap::Cursor records, const RecordVisitor& visit) const;
  McapAttachment attachment_head(const mcap::Record& record) const;
  mcap::Statistics count_records() const;
  void verify_data_crc(const mcap::Record& data_end) const;

  InputFile file_;
  Limits limits_;
  std::uint64_t data_end_ = 0;  // where reading of the data section stops [B]
  std::uint64_t retained_ = 0;  // [B]
  std::string problem_, profile_, library_;
  std::map<std::uint16_t, McapSchema> schemas_;
  std::map<std::uint16_t, McapChannel> channels_;
  std::vector<McapAttachment> attachments_;
  std::vector<McapMetadata> metadata_;
  mcap::Statistics statistics_;
};

}  // namespace trocar
