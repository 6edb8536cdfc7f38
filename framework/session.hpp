// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/graph.hpp"
#include "framework/highlights.hpp"
#include "framework/recording/log_file.hpp"
#include "framework/run.hpp"
#include "framework/service.hpp"
#include "framework/session_captures.hpp"

namespace trocar {

/// What the command line says about a session; it wins over the script.
struct SessionOptions {
  ClockKind clock = ClockKind::realtime;
  LoopTiming timing{};
  std::optional<double> duration{};            // [s] --for
  double default_duration = 10.0;              // [s] in virtual time, where nobody says
  std::optional<std::uint64_t> seed{};         // --seed
  std::optional<std::string> record{};         // --record
  Graph::Overrides set{};                      // --set
  std::optional<BlackBoxOptions> black_box{};  // --black-box
  bool check_only = false;                     // stop at the first run
  bool write_files = true;                     // logs and captures that the script asks for
  bool print_to_stderr = false;                // what the script prints
  AllocationCount allocations = nullptr;       // see RunOptions
  const StopFlag* stop = nullptr;
  std::function<bool(RunControl&)> operator_input{};  // see RunOptions
  bool reloadable = false;                            // laws may be reloaded by operator_input
  RowSink* watch = nullptr;                           // of every run
  std::vector<Service*> services{};                   // beside every run
};

/// A row of results that a script published: names and values, in the script's order.
struct Published {
  std::string name;
  Literal row;
};

/// One run of a session with what it looked like.
struct SessionRun {
  RunResult result;
  Highlights highlights;
  CaptureResult captured{};
};

/// What a script asked for and what came of it. A script describes a graph and may run it several
/// times; a session carries that out and keeps the log, the results and the report together.
class Session {
 public:
  Session(const Registry& registry, SessionOptions options);

  Graph& graph() { return graph_; }
  const SessionOptions& options() const { return options_; }

  /// A script's text, for the log.
  void add_script(std::string name, std::string text);
  /// How the script would run the graph first, for those who only look at it.
  const std::optional<RunOptions>& planned() const { return planned_; }
  WiringOptions first_wiring() const { return planned_ ? planned_->wiring : WiringOptions{}; }
  void plan(RunOptions first) { planned_ = std::move(first); }
  /// Runs the graph as it stands; `wanted` is what the script asks, the options win.
  /// @throw BrokenGraph with every finding
  const SessionRun& run(RunOptions wanted);
  void publish(std::string name, Literal row);
  /// Closes the log.
  void finish();

  const std::vector<std::unique_ptr<SessionRun>>& runs() const { return runs_; }
  const std::vector<Published>& published() const { return published_; }
  const std::string& log_path() const { return log_path_; }
  /// Messages about the log that a user must see.
  const std::vector<std::string>& troubles() const { return troubles_; }
  /// Whether everything ran without a fault or a loss.
  bool sound() const;

 private:
  void add_services(RunOptions& wanted) const;
  void open_log(const WiredGraph* wired);
  void attach_reloads(const RunResult& result);
  std::string wanted_log() const;
  std::vector<RowSink*> begin_captures(const WiredGraph& wired);
  std::string stem() const;
  void trouble(const std::string& message);
  void try_log(const std::function<void()>& write);
  RowLayout::Selection selection() const;

  SessionOptions options_;
  Graph graph_;
  std::optional<RunOptions> planned_{};
  std::vector<std::pair<std::string, std::string>> scripts_;
  std::unique_ptr<LogFile> log_;
  std::string log_path_;
  bool log_opened_ = false;
  SessionCaptures captures_;
  std::vector<std::unique_ptr<SessionRun>> runs_;
  std::vector<Published> published_;
  std::vector<std::string> troubles_;
};

}  // namespace trocar
