// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "framework/recording/mcap_format.hpp"
#include "framework/recording/output_file.hpp"

namespace trocar {

/// Writes an MCAP file in uncompressed, indexed chunks (https://mcap.dev/spec).
///
/// The bytes depend on the calls alone: no date, host or path gets in, and chunks
/// close by size and by the messages' own time, never by a clock. A file that was
/// not closed is readable up to its last whole chunk. For one thread, not the loop's.
class McapWriter {
 public:
  struct Settings {
    std::string profile = "ros2";
    std::string library = default_library();
    std::size_t chunk_size = std::size_t{1} << 20;  // [B], a chunk closes once it has as many
    std::uint64_t chunk_duration = 500'000'000;     // [ns] of log time that a chunk may span
  };

  /// "trocar" and its version.
  static std::string default_library();

  /// @throw std::runtime_error when the file cannot be written: path, reason, cure.
  explicit McapWriter(const std::string& path) : McapWriter(path, Settings()) {}
  McapWriter(const std::string& path, Settings settings);
  /// Closes the file; a failure is swallowed, so call close() to hear of it.
  ~McapWriter();

  // Each call below throws std::runtime_error when the disk refuses (and then every
  // time), and std::logic_error after close().

  /// @throw std::invalid_argument for an empty name, or a 65536th schema.
  std::uint16_t schema(std::string_view name, std::string_view encoding, std::string_view data);

  /// @param schema_id from schema(), or 0 for none
  /// @throw std::invalid_argument for an unknown schema, or a 65537th channel.
  std::uint16_t channel(std::string_view topic, std::uint16_t schema_id,
                        std::string_view message_encoding, const mcap::Metadata& metadata = {});

  /// @throw std::invalid_argument for an unknown channel.
  void message(std::uint16_t channel, std::uint32_t sequence, std::uint64_t log_time_ns,
               std::uint64_t publish_time_ns, std::span<const std::byte> payload);

  /// @param create_time_ns 0 when unknown
  void attachment(std::string_view name, std::string_view media_type, std::uint64_t log_time_ns,
                  std::uint64_t create_time_ns, std::span<const std::byte> data);

  void metadata(std::string_view name, const mcap::Metadata& entries);

  /// Hands the open chunk to the system. It moves a chunk's border: where bytes must
  /// repeat, call it only at moments that repeat.
  void flush();

  /// Waits until the disk has every chunk that was handed over (for the recorder thread).
  void sync() { file_.sync(); }

  /// Writes the summary and closes the file; may be called again.
  void close();

  // What was accepted so far, the open chunk included.
  std::uint64_t bytes_written() const { return file_.size() + chunk_.size(); }
  std::uint64_t message_count() const { return message_count_; }
  std::uint64_t message_count(std::uint16_t channel) const;
  std::uint64_t payload_bytes() const { return payload_bytes_; }

 private:
  struct ChannelState {
    std::uint64_t count = 0;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> index;  // log time [ns], offset [B]
  };
  struct TimeRange {
    std::uint64_t first = 0, last = 0;  // [ns]
    void include(std::uint64_t time, bool is_first);
  };

  void begin_file();
  void close_chunk();
  void append_message_indexes(mcap::Bytes& after, std::uint64_t start, mcap::Bytes& offsets);
  void append_statistics(mcap::Bytes& summary) const;
  void append_summary();

  Settings settings_;
  OutputFile file_;
  bool closed_ = false;
  mcap::Bytes chunk_, scratch_;
  TimeRange chunk_time_, file_time_;
  std::uint64_t chunk_first_ = 0;  // log time of the chunk's first message [ns]
  std::vector<ChannelState> channels_;
  std::uint64_t message_count_ = 0, payload_bytes_ = 0;
  // Copies and indexes that go into the summary, as finished records.
  mcap::Bytes schemas_, channel_records_, chunk_indexes_, attachment_indexes_, metadata_indexes_;
  std::uint32_t schema_count_ = 0, chunk_count_ = 0, attachment_count_ = 0, metadata_count_ = 0;
};

}  // namespace trocar
