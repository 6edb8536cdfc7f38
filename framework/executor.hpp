// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "framework/clock.hpp"
#include "framework/command.hpp"
#include "framework/event.hpp"
#include "framework/gate.hpp"
#include "framework/parameter_ramps.hpp"
#include "framework/realtime/record_ring.hpp"
#include "framework/realtime/stop_flag.hpp"
#include "framework/realtime/timing_histogram.hpp"
#include "framework/recording/row_layout.hpp"
#include "framework/stepper.hpp"

namespace trocar {

struct ExecutorOptions {
  std::int64_t ticks = -1;            // slots to run; -1 runs until stopped
  bool timing = true;                 // measure every component in every tick
  double edit_ramp = 0.2;             // [s] of a live edit
  std::vector<Command> schedule{};    // by not_before
  CommandQueue* commands = nullptr;   // from another thread
  RecordRing* records = nullptr;      // rows and events go there
  const RowLayout* layout = nullptr;  // of the rows
  const StopFlag* stop = nullptr;
};

/// Figures of a run.
struct LoopStatistics {
  std::int64_t ticks = 0;    // that were run
  std::int64_t skipped = 0;  // slots that were not
  std::int64_t rows = 0;     // handed over
  std::int64_t rows_lost = 0;
  TimingHistogram lateness;
  TimingHistogram duration;
  std::vector<TimingHistogram> components{};  // in the order of the schedule
};

/// Runs a wired graph once, tick by tick: commands → devices report → step in order → gates write
/// → the row is handed over. Everything it does in a tick is bounded, allocates nothing and waits
/// for nobody but its clock.
class Executor {
 public:
  Executor(WiredGraph& graph, ExecutorOptions options);

  /// From start() to stop() of all components, in the calling thread.
  void run(Clock& clock);

  // The parts of run(), for tests that step by hand.
  void start();
  void tick(const Slot& slot, bool simulated) RT_SAFE;
  void stop(const Slot& last, bool simulated) RT_SAFE;

  const LoopStatistics& statistics() const { return statistics_; }
  const FaultLatch& faults() const { return faults_; }
  const std::deque<Gate>& gates() const { return gates_; }

 private:
  void take_commands(const Tick& tick) RT_SAFE;
  void obey(const Command& command, const Tick& tick) RT_SAFE;
  void acknowledge(Event event) RT_SAFE;
  void step_all(const Tick& tick) RT_SAFE;
  void pass_gates(const Tick& tick) RT_SAFE;
  void report_changes(const Tick& tick) RT_SAFE;
  void send(const Event& event) RT_SAFE;
  void send_row(const Tick& tick, const Slot& slot) RT_SAFE;
  std::span<std::byte> room(std::size_t size) RT_SAFE;

  WiredGraph& graph_;
  ExecutorOptions options_;
  FaultLatch faults_;
  std::deque<Gate> gates_;
  std::vector<Gate::State> gate_states_;  // last reported
  Stepper stepper_;
  std::vector<std::int64_t> times_;  // [ns] of each component in this tick
  ParameterRamps ramps_;
  LoopStatistics statistics_;
  std::size_t next_scheduled_ = 0;
  std::size_t faults_reported_ = 0;
  std::int64_t last_duration_ = 0;
  bool simulated_ = false;
  bool ended_ = false;
};

}  // namespace trocar
