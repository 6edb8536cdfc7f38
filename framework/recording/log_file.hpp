// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "framework/recording/mcap_writer.hpp"
#include "framework/recording/row_sink.hpp"

namespace trocar {

/// The log of a session: rows and events of its runs, published results, and as attachments what
/// is needed to understand them. In virtual time its bytes depend on nothing else.
class LogFile {
 public:
  /// @param epoch_ns added to all times: 0 in virtual time, else the date of the start
  /// @throw std::runtime_error when the file cannot be written
  LogFile(const std::string& path, std::uint64_t epoch_ns);

  const std::string& path() const { return path_; }
  std::uint64_t start_ns() const { return start_ns_; }  // of the run that begins next
  void attach(std::string_view name, std::string_view media_type, std::string_view content);
  /// A result that a script published; `json` is one object.
  void publish(std::string_view name, std::string_view json);
  void close();

  McapWriter& writer() { return writer_; }
  /// Topics of the n-th run: "/main" (a thread's name), "/run2/main", …
  std::string topic(std::string_view name) const;
  std::uint64_t begin_run() { return ++run_, start_ns_; }
  void end_run(std::uint64_t last_ns) { start_ns_ = last_ns; }

 private:
  std::string path_;
  McapWriter writer_;
  std::uint64_t start_ns_;  // of the run, in log time
  int run_ = 0;
  std::uint32_t published_ = 0;
  std::uint16_t published_channel_ = 0;
  bool has_published_channel_ = false;
};

/// Writes one run's rows and events into a log.
class Recorder final : public RowSink {
 public:
  /// @param wanted which ports; a device's are recorded always
  Recorder(LogFile& log, RowLayout::Selection wanted);
  std::string_view reader_name() const override { return name; }
  void begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) override;
  void row(std::size_t group, std::span<const std::byte> row) override;
  void event(std::size_t group, const Event& event) override;
  /// An event of kind "rows missed" stands before what comes next.
  void missed(std::uint64_t records) override { missed_ += records; }
  void end() override;

  static constexpr const char* name = "recorder";

 private:
  void write_missed(std::size_t group, std::int64_t tick, std::int64_t time_ns);
  void write(std::size_t group, const Event& event);
  struct Piece {  // of a full row, taken into the narrower one
    std::size_t from, to, size;
  };
  LogFile& log_;
  RowLayout::Selection wanted_;
  struct Group {  // a thread's rows
    std::string name;
    std::vector<Piece> pieces;
    std::vector<std::byte> message;
    std::uint16_t channel = 0;
  };
  Group begin_group(const RowLayout& layout, const RowLayout& narrow);
  std::vector<Group> groups_;
  std::uint16_t events_ = 0;
  std::uint32_t event_count_ = 0;
  std::uint64_t missed_ = 0;  // and not written yet
  std::uint64_t start_ns_ = 0;
  std::uint64_t last_ns_ = 0;
};

}  // namespace trocar
