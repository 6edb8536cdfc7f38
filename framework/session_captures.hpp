// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/black_box.hpp"
#include "framework/graph.hpp"
#include "framework/recording/file_series.hpp"

namespace trocar {

/// What the captures and the black box of a session came to in a run.
struct CaptureResult {
  std::vector<TriggeredFile> files{};
  std::vector<std::string> notes{};     // what a reader of the report should know
  std::vector<std::string> troubles{};  // files that could not be written
};

/// The black box and the captures of a session: a reader of rows for each in every run, and the
/// names of their files over all runs. Each writes at most eight files in a session.
class SessionCaptures {
 public:
  struct Run {
    const Graph& graph;
    std::string stem;  // of the black box's name
    std::uint64_t epoch_ns = 0;
    std::vector<TriggeredLog::Attachment> attachments{};
  };
  static constexpr std::size_t most_files = 8;

  explicit SessionCaptures(std::optional<BlackBoxOptions> black_box)
      : black_box_(std::move(black_box)) {}

  /// Whether a run has anything to capture.
  bool wanted(const Graph& graph) const;
  /// @throw BrokenGraph when two captures, or one and the log, write the same file
  void check_files(const Graph& graph, const std::string& log_path) const;
  /// The readers of a run that is about to begin; they live until the next begins.
  std::vector<RowSink*> begin(const Run& run);
  /// What they wrote, once the run has ended.
  CaptureResult end();

 private:
  struct One {
    std::string name;
    std::unique_ptr<Trigger> trigger;
    std::unique_ptr<TriggeredLog> log;
  };
  struct Files {
    FileSeries series;
    std::size_t left = most_files;
  };
  void add(const Run& run, const std::string& name, std::unique_ptr<Trigger> trigger,
           const FileSeries& series);

  std::optional<BlackBoxOptions> black_box_;
  std::map<std::string, Files> files_;  // by "black box", or the capture's name
  std::vector<One> active_;
};

}  // namespace trocar
