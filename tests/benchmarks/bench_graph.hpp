// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "framework/executor.hpp"

namespace trocar::bench {

/// A graph that the executor's own tick runs, without a clock: one tick a call, each in its slot.
class BenchGraph {
 public:
  BenchGraph() = default;
  BenchGraph(const BenchGraph&) = delete;
  BenchGraph& operator=(const BenchGraph&) = delete;

  NodeId add(std::string_view type, std::string_view name = "") {
    return graph.add(type, name, {"benchmark", 1}).value();
  }
  void connect(const OutputRef& from, const InputRef& to) {
    graph.connect(from, to, {"benchmark", 1});
  }
  /// @throw BrokenGraph with every finding
  void start(bool timing = false) {
    wired = wire(graph, {});
    executor.emplace(wired->main(), ExecutorOptions{.timing = timing, .commands = &commands});
    executor->start();
  }
  void tick() {
    executor->tick({.index = next_, .date_ns = next_ + 1}, false);  // a date: the heart beats
    ++next_;
  }

  Registry types;
  Graph graph{types};
  CommandQueue commands;  // stays empty, and is looked at in every tick
  std::unique_ptr<WiredGraph> wired;
  std::optional<Executor> executor;

 private:
  std::int64_t next_ = 0;
};

}  // namespace trocar::bench
