// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framework/realtime/exclusive.hpp"
#include "framework/recording/log_file.hpp"

namespace trocar::foxglove {

/// A log that a client asked for while a run goes on, beside the session's own. Rows come from one
/// thread, orders from another.
class Recording {
 public:
  struct State {
    std::string file;  // "" when nothing is being recorded
    std::uint64_t rows = 0;
    std::uint64_t missed = 0;
  };

  void add_script(const std::string& name, const std::string& text);
  /// Name and SHA-256 of the first script, which the others were required by; "" before it.
  struct Mark {
    std::string name;
    std::string sha256;
  };
  Mark mark();
  /// A run begins, whose layouts and graph live until end_run().
  void begin_run(const std::vector<RowLayout>& layouts, const WiredGraph& graph,
                 std::uint64_t epoch_ns, std::string graph_json);
  void end_run();

  /// @param name of a file beside the program's other logs, or "" for one of its own
  /// @return its name
  /// @throw std::runtime_error when there is no run, one is being recorded, or the name does not do
  std::string start(const std::string& name);
  /// @throw std::runtime_error when nothing is being recorded
  State stop();
  State state();

  void row(std::size_t group, std::span<const std::byte> row);
  void event(std::size_t group, const Event& event);
  void missed(std::uint64_t records);
  /// The session's own log takes no more rows.
  void fail_log(const std::string& why);
  /// Why, or "": of the run that goes on.
  std::string log_trouble();
  /// Why a recording, a client's or the session's, was given up since the last call, or "".
  std::string take_trouble();

 private:
  struct Open {
    Open(const std::string& file, std::uint64_t epoch_ns) : log(file, epoch_ns) {
      state.file = file;
    }
    LogFile log;
    Recorder recorder{log, {}};
    State state;
  };
  void attempt(const auto& write);

  Exclusive exclusive_;  // of all below
  std::vector<std::pair<std::string, std::string>> scripts_;
  Mark mark_;
  const std::vector<RowLayout>* layouts_ = nullptr;
  const WiredGraph* graph_ = nullptr;
  std::uint64_t epoch_ns_ = 0;
  std::string graph_json_;
  std::unique_ptr<Open> open_;
  std::string trouble_, log_trouble_;
};

}  // namespace trocar::foxglove
