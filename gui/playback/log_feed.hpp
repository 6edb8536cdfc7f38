// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gui/data/data_store.hpp"
#include "gui/playback/log_runs.hpp"

namespace trocar::gui {

/// Fills a store from a run in a log, a slice at a time, so that whoever looks on can go on.
///
/// Of a run that is larger than the limit the rows around the time asked for are kept, and all its
/// events. A damaged log is read as far as it goes; problem() says why no farther.
class LogFeed : public QObject {
  Q_OBJECT

 public:
  struct Limits {
    std::size_t memory = std::size_t{1} << 30;  // [B] of rows
    std::size_t slice = 2048;                   // rows; a slice ends with the chunk that has more
  };
  struct Span {
    double from = 0.0, to = 0.0;  // [s] since the run's start, both included
    bool holds(double time) const { return time >= from && time <= to; }
  };
  enum class State { empty, loading, loaded, cancelled };

  explicit LogFeed(DataStore& store, QObject* parent = nullptr)
      : LogFeed(store, Limits{}, parent) {}
  LogFeed(DataStore& store, Limits limits, QObject* parent = nullptr);

  /// Begins to load the log's first run.
  /// @throw std::runtime_error when the file cannot be read, is no MCAP file or has no rows
  void open(const std::string& path);
  void choose(int run);           // @param run of runs(), by its number
  void load_around(double time);  // [s] of the run; loads nothing when it is there
  void cancel();                  // what came stays

  State state() const { return state_; }
  double progress() const;  // 0 to 1
  const std::string& path() const { return path_; }
  const std::string& problem() const { return problem_; }
  const std::vector<LogRun>& runs() const { return runs_; }
  int run() const { return run_; }
  Span whole() const { return whole_; }      // the run
  Span loaded() const;                       // what there are rows of
  bool is_part() const { return is_part_; }  // the run is larger than the limit
  /// "run 1 of 2, 10.0 s", "30.0 to 90.0 s of 600.0 s: the limit is 1024 MiB", or how far it is.
  std::string summary() const;
  /// The log's graph.json (docs/log-format.md); null when it has none.
  const nlohmann::json& graph() const { return graph_; }
  /// The log's first script, which the others were required by; empty when it has none, or damaged.
  struct Script {
    std::string name, text;
  };
  Script script() const;

 Q_SIGNALS:
  void opened();    // another log, or another run of it
  void advanced();  // a slice came, or it is done: state(), progress()

 private:
  const LogRun& current() const;
  void begin(double around);
  std::vector<std::unique_ptr<Track>> make_tracks(double share) const;
  void load_slice();
  void take(const McapMessage& message);
  void take_row(const LogRun::Thread& thread, const McapMessage& message);
  void finish(State state);
  void read_graph();

  DataStore& store_;
  Limits limits_;
  QTimer timer_;
  std::string path_, problem_;
  std::unique_ptr<McapReader> log_;
  std::vector<LogRun> runs_;
  int run_ = 0;
  State state_ = State::empty;
  std::uint64_t place_ = 0;            // in the file [B]
  std::size_t in_slice_ = 0;           // rows
  std::optional<std::int64_t> epoch_;  // [ns] log time less the run's time
  Span whole_, wanted_;
  bool is_part_ = false;
  std::vector<RunEvent> events_;
  bool knows_events_ = false;  // all of the run
  nlohmann::json graph_;
};

}  // namespace trocar::gui
