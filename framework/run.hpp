// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/edit_schedule.hpp"
#include "framework/executor.hpp"
#include "framework/recording/row_sink.hpp"
#include "framework/recording/row_store.hpp"
#include "framework/run_control.hpp"

namespace trocar {

/// `device`: threads with a device that paces tick by its reports, the others as in real time.
enum class ClockKind { realtime, simulated, device };

/// "realtime", as --clock and reports call it.
const char* to_string(ClockKind clock);

/// How the loop keeps time, and what follows when it cannot. In virtual time none of it applies.
struct LoopTiming {
  double spin = 0.0;          // [s] busy-waiting before each slot, shorter than the period; 0: off
  bool hold_latency = false;  // keep the processors out of deep sleep, see CpuLatencyHold
  OverloadSettings overload{};
};

struct RunOptions {
  ClockKind clock = ClockKind::realtime;
  LoopTiming timing{};
  std::optional<double> duration{};  // [s]; without one it runs until stopped
  WiringOptions wiring{};
  std::vector<Edit> edits{};
  std::vector<OperatorRequest> requests{};  // at their times
  std::vector<Reload> reloads{};            // at their times; see WiringOptions::reloadable
  /// In real time, called some hundred times a second on a thread of its own, for somebody who
  /// watches and intervenes. @return whether there was something to do
  std::function<bool(RunControl&)> operator_input{};
  /// From the same thread: a reader of rows was given up, and the run goes on.
  std::function<void(const ReaderFailure&)> reader_failed{};
  bool engage = true;               // ask to render as soon as it is safe
  bool keep_rows = false;           // for an experiment to compute with
  std::vector<std::string> keep{};  // signals, ports or components of which; all when empty
  std::vector<RowSink*> sinks{};
  AllocationCount allocations = nullptr;  // to keep what each component's steps cost
  const StopFlag* stop = nullptr;
};

/// A fault with its texts, which outlive the graph.
struct FaultRecord {
  std::string cause;
  std::string component;
  std::string detail;
  double value = 0.0;
  double limit = 0.0;
  std::int64_t tick = 0;
  double time = 0.0;  // [s]

  std::string text() const;
};

struct ComponentTiming {
  std::string name;
  TimingHistogram time;
  StepCost cost{};  // where RunOptions::allocations is given
};

/// What one thread of a run came to.
struct ThreadResult {
  std::string name;
  double rate = 0.0;      // [Hz]
  LoopStatistics loop{};  // without its components' times
  std::vector<ComponentTiming> components{};
};

/// What a run came to.
struct RunResult {
  ClockKind clock = ClockKind::realtime;
  std::vector<ThreadResult> threads{};
  double duration = 0.0;   // [s] of its own time
  double wall_time = 0.0;  // [s]
  double spin = 0.0;       // [s] as asked for
  bool latency_held = false;
  bool interrupted = false;
  std::vector<FaultRecord> faults{};        // of all threads, by time
  std::vector<ReloadVerdict> reloads{};     // in their order
  std::vector<std::string> shortcomings{};  // of the machine, for real time
  std::vector<std::string> lost{};          // readers of rows that gave up, and why
  std::vector<ReaderLoss> missed{};         // readers of rows that fell behind
  std::shared_ptr<RowStore> rows{};

  /// The first thread, and the only one where a script declares none.
  const ThreadResult& main() const { return threads.front(); }
};

/// "" when the guard spin suits every thread, else what is wrong.
std::string check_spin(const RunOptions& options, const Graph& graph);

/// Wires the graph and runs it once.
/// @throw BrokenGraph with every finding
/// @throw std::invalid_argument when options.timing is out of range
RunResult run(const Graph& graph, const RunOptions& options);

}  // namespace trocar
