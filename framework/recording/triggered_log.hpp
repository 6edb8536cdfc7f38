// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/recording/log_file.hpp"
#include "framework/recording/record_history.hpp"

namespace trocar {

/// Decides when a TriggeredLog writes.
class Trigger {
 public:
  struct Window {
    double before = 1.0;  // [s]
    double after = 1.0;   // [s]
  };
  virtual ~Trigger() = default;
  /// Before the first row.
  virtual Window begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) = 0;
  /// Whether this row, or this event, is a reason to write.
  virtual bool row(std::size_t /*group*/, std::span<const std::byte>) { return false; }
  virtual bool event(std::size_t /*group*/, const Event&) { return false; }
  /// The reason in words, after one of the above said so.
  virtual std::string cause() const = 0;
};

/// A file that a TriggeredLog wrote.
struct TriggeredFile {
  std::string writer;  // "black box"
  std::string path;
  std::string cause;       // the first, where several share the file
  double from = 0.0;       // [s] of its first row
  double to = 0.0;         // [s] of its last row
  std::uint64_t rows = 0;  // in it
};

/// Keeps the last seconds of all rows and events in memory. When its trigger says so it writes
/// them, and what comes for some seconds more, into a log of its own. Triggers whose times overlap
/// share a file. A disk that refuses costs the file and not the run.
class TriggeredLog final : public RowSink {
 public:
  struct Attachment {
    std::string name, media_type, text;
  };
  struct Options {
    std::string name{};                              // "black box"
    std::uint64_t epoch_ns = 0;                      // of the files' times: see LogFile
    std::size_t most_files = 8;                      // what comes after that is counted
    std::size_t most_memory = std::size_t{1} << 30;  // [bytes]
    std::vector<Attachment> attachments{};
    std::function<std::string()> next_path{};
  };
  TriggeredLog(Trigger& trigger, Options options);

  std::string_view reader_name() const override { return options_.name; }
  /// @throw std::runtime_error when the seconds before a trigger take too much memory
  void begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) override;
  void row(std::size_t group, std::span<const std::byte> row) override;
  void event(std::size_t group, const Event& event) override;
  void missed(std::uint64_t records) override { missed_ += records; }
  void end() override { close(); }

  const std::vector<TriggeredFile>& files() const { return files_; }
  /// Why files were not written.
  const std::vector<std::string>& troubles() const { return troubles_; }
  /// How often the trigger found that there were enough files.
  std::uint64_t refused() const { return refused_; }

 private:
  void take_missed(std::size_t group, std::int64_t tick, std::int64_t time_ns);
  void take(std::uint32_t tag, std::span<const std::byte> record, std::int64_t time_ns,
            bool triggered);
  void open(std::int64_t time_ns);
  void catch_up(std::int64_t since_ns);
  void write(std::uint32_t tag, std::span<const std::byte> record);
  void close();
  void attempt(const auto& what);

  static constexpr std::int64_t long_ago = std::numeric_limits<std::int64_t>::min() / 2;
  Trigger& trigger_;
  Options options_;
  const std::vector<RowLayout>* layouts_ = nullptr;
  const WiredGraph* graph_ = nullptr;
  std::optional<RecordHistory> history_;
  std::int64_t before_ns_ = 0;
  std::int64_t after_ns_ = 0;
  std::uint64_t missed_ = 0;  // and not told yet

  std::unique_ptr<LogFile> log_;  // that is open
  std::optional<Recorder> recorder_;
  std::int64_t until_ns_ = long_ago;  // it takes what comes
  std::uint64_t written_up_to_ = 0;   // of the history's records
  bool resting_ = false;              // what it took is with the system

  std::vector<TriggeredFile> files_;
  std::vector<std::string> troubles_;
  std::size_t opened_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace trocar
