// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "framework/command.hpp"
#include "framework/wired_graph.hpp"

namespace trocar {

/// A graph that runs, in the hands of somebody outside of its loop, who may be as slow as people
/// are. For one thread at a time. Whatever is asked takes effect at the beginning of a tick; what
/// a queue cannot take yet is kept and handed over at the next flush().
class RunControl {
 public:
  /// @param live the graph that runs
  /// @param queues one for each of its groups, of which this is the only writer
  RunControl(const Graph& graph, const WiringOptions& options, const WiredGraph& live,
             std::deque<CommandQueue>& queues);
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
  /// Keys of parameters that set() takes.
  std::vector<std::string> live_keys();
  /// Hands over what waits. @return whether something still does
  bool flush();

 private:
  struct Twin;
  Twin& twin();

  const Graph& graph_;
  const WiringOptions& options_;
  const WiredGraph& live_;
  std::deque<CommandQueue>& queues_;
  std::vector<std::deque<Command>> waiting_;  // for each queue
  std::unique_ptr<Twin> twin_;
};

}  // namespace trocar
