// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "framework/clock.hpp"
#include "framework/command.hpp"
#include "framework/event.hpp"
#include "framework/exchange.hpp"
#include "framework/gate.hpp"
#include "framework/overload.hpp"
#include "framework/parameter_ramps.hpp"
#include "framework/realtime/broadcast_ring.hpp"
#include "framework/realtime/heartbeat.hpp"
#include "framework/realtime/stop_flag.hpp"
#include "framework/realtime/timing_histogram.hpp"
#include "framework/recording/row_layout.hpp"
#include "framework/reloads.hpp"
#include "framework/step_cost.hpp"
#include "framework/stepper.hpp"

namespace trocar {

struct ExecutorOptions {
  std::int64_t ticks = -1;            // slots to run; -1 runs until stopped
  bool timing = true;                 // measure every component in every tick
  double edit_ramp = 0.2;             // [s] of a live edit
  std::vector<Command> schedule{};    // by not_before
  CommandQueue* commands = nullptr;   // from another thread
  BroadcastRing* records = nullptr;   // rows and events go there
  const RowLayout* layout = nullptr;  // of the rows
  const StopFlag* stop = nullptr;
  StopFlag* end_all = nullptr;  // of all threads; raised when this one ends the run
  OverloadSettings overload{};
  AllocationCount allocations = nullptr;  // with timing: keep what steps and ticks cost
  std::uint32_t index = 0;                // of the group: goes with each of its rows and events
};

/// Figures of a run.
struct LoopStatistics {
  std::int64_t ticks = 0;      // that were run
  std::int64_t skipped = 0;    // slots that were not
  std::int64_t overruns = 0;   // ticks that were not over when their next slot was due
  std::int64_t spun_ns = 0;    // busy-waiting
  std::int64_t rows = 0;       // handed over
  std::int64_t rows_lost = 0;  // rows and events that no ring could take
  TimingHistogram lateness;
  TimingHistogram duration;
  std::vector<TimingHistogram> components{};  // in the order of the schedule
  StepCost tick_cost{};                       // where allocations are counted
  std::vector<StepCost> costs{};              // likewise, of components
};

/// Runs what one thread of a wired graph does, once, tick by tick: commands → what other threads
/// sent → devices report → step in order → gates write → what other threads get → the row is handed
/// over → what may wait is done. Everything it does in a tick is bounded, allocates nothing and
/// waits for nobody but its clock.
class Executor {
 public:
  Executor(const RateGroup& group, ExecutorOptions options);

  /// From start() to stop() of all components, in the calling thread.
  void run(Clock& clock);

  // The parts of run(), for those who step it among others.
  void start();
  /// Until the end, by a clock that was started.
  void loop(Clock& clock);
  /// Its time is over, or somebody ended the run.
  bool over() const RT_SAFE;
  void tick(const Slot& slot, bool simulated) RT_SAFE;
  void stop(const Slot& last, bool simulated) RT_SAFE;

  const LoopStatistics& statistics() const { return statistics_; }
  const FaultLatch& faults() const { return faults_; }
  const std::deque<Gate>& gates() const { return gates_; }
  const RateGroup& group() const { return group_; }
  /// Beats in every tick of the periodic clock.
  Heartbeat& heartbeat() { return heartbeat_; }
  OverloadPolicy overload_policy() const { return overload_.settings().policy; }

 private:
  void judge_time(const Tick& tick, const Slot& slot) RT_SAFE;
  void react_to(const Overload& overload, const Tick& tick) RT_SAFE;
  const char* who_was_silent(std::int64_t silent_ns) const RT_SAFE;
  void judge_silence(const Tick& tick, std::int64_t silent_ns) RT_SAFE;
  void give_up_rendering(const Fault& fault) RT_SAFE;
  void take_commands(const Tick& tick) RT_SAFE;
  void move_ramps() RT_SAFE;
  void obey(const Command& command, const Tick& tick) RT_SAFE;
  void acknowledge(Event event) RT_SAFE;
  void replace(ReloadTicket& ticket, Event event) RT_SAFE;
  void report_reloads(const Tick& tick) RT_SAFE;
  void step_all(const Tick& tick, std::int64_t begin) RT_SAFE;
  Tick tick_of(std::int64_t index) const RT_SAFE;
  void pass_gates(const Tick& tick) RT_SAFE;
  void send_across(const Tick& tick) RT_SAFE;
  void end() RT_SAFE;
  void use_slack() RT_SAFE;
  void report_changes(const Tick& tick) RT_SAFE;
  void report_faults() RT_SAFE;
  void report_gates(const Tick& tick) RT_SAFE;
  void send(const Event& event) RT_SAFE;
  void send_row(const Tick& tick, const Slot& slot) RT_SAFE;
  void hand_over(RecordKind kind) RT_SAFE;

  const RateGroup& group_;
  ExecutorOptions options_;
  FaultLatch faults_;
  std::deque<Gate> gates_;
  std::vector<Gate::State> gate_states_;  // last reported
  Stepper stepper_;
  Exchange exchange_;
  std::vector<Component*> in_slack_;  // those that have work for it
  struct Part {
    Replaceable* part;
    const char* owner;
  };
  std::vector<Part> parts_;          // that can be replaced
  std::vector<std::int64_t> times_;  // [ns] of each component in this tick
  ParameterRamps ramps_;
  OverloadMonitor overload_;
  Heartbeat heartbeat_;
  LoopStatistics statistics_;
  std::span<const Command> scheduled_;  // still to come
  std::size_t faults_reported_ = 0;
  std::int64_t last_duration_ = 0;
  bool simulated_ = false;
  bool ended_ = false;
  bool edited_ = false;  // something was done before the components' turn
};

}  // namespace trocar
