// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/command.hpp"
#include "framework/reloads.hpp"
#include "framework/units.hpp"
#include "framework/wired_graph.hpp"

namespace trocar {

/// A parameter as it was asked for last, for those who show it.
struct ParameterState {
  std::string key;                // "wall.stiffness"
  std::string text;               // as a script would write it, with its unit
  std::vector<double> numbers{};  // in SI; none where it is no number
  Unit unit{};                    // in which people see it
  double min = 0.0;               // in SI; -infinity where there is no bound
  double max = 0.0;
  std::string doc;
  std::vector<std::string> choices{};
  bool live = false;  // set() takes it
};

/// A graph that runs, in the hands of somebody outside of its loop, who may be as slow as people
/// are. For one thread at a time. Whatever is asked takes effect at the beginning of a tick; what
/// a queue cannot take yet is kept and handed over at the next flush().
class RunControl {
 public:
  /// @param live the graph that runs
  /// @param queues one for each of its groups, of which this is the only writer
  /// @param reloads of this run
  RunControl(const Graph& graph, const WiringOptions& options, const WiredGraph& live,
             std::deque<CommandQueue>& queues, Reloads& reloads);
  ~RunControl();

  /// Asks it of all threads.
  void request(Command::Kind kind);
  /// Moves a live parameter, and those that follow it, to a new value under a ramp.
  /// @param key "wall.stiffness"
  /// @param value as a script would write it
  /// @throw BrokenGraph when it is no live parameter, or the value does not fit
  void set(const std::string& key, const Literal& value);
  /// The value that a parameter was given last, as a script would write it, with its unit.
  /// @throw BrokenGraph when there is no such parameter
  std::string text(const std::string& key);
  /// All of them, in the order of the graph.
  std::vector<ParameterState> parameters();
  /// Keys of parameters that set() takes.
  std::vector<std::string> live_keys();
  /// Makes a new version of a component's part ready, tries it, and sends it to the loop.
  /// @return why not, or ""; the loop may still give it up: see reload_troubles()
  /// @throw std::invalid_argument for a component that has no such part
  std::string reload(Reload reload);
  /// The same of a reload that was announced before the run.
  std::string reload(const Reloads::Issued& issued);
  /// A remark for the log, at the next tick.
  void annotate(std::string text);
  /// Components with parts that can be reloaded, and their files.
  std::vector<Reloads::Part> parts() const { return reloads_.parts(); }
  /// Reloads that the loop has given up since the last call.
  std::vector<ReloadVerdict> reload_troubles() { return reloads_.take_troubles(); }
  /// The loops have begun.
  void begin();
  /// [s] since begin(), 0 before
  double time() const;
  /// Hands over what waits. @return whether something still does
  bool flush();

 private:
  struct Twin;
  Twin& twin();

  const Graph& graph_;
  const WiringOptions& options_;
  const WiredGraph& live_;
  std::deque<CommandQueue>& queues_;
  Reloads& reloads_;
  std::optional<std::int64_t> begin_ns_;
  std::deque<std::string> remarks_;
  std::vector<std::deque<Command>> waiting_;  // for each queue
  std::unique_ptr<Twin> twin_;
};

}  // namespace trocar
