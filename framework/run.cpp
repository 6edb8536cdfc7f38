// SPDX-License-Identifier: Apache-2.0
#include "framework/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "framework/loop_runner.hpp"
#include "framework/realtime/background_poller.hpp"
#include "framework/realtime/cpu_latency_hold.hpp"
#include "framework/realtime/throttling.hpp"
#include "framework/recording/row_pump.hpp"
#include "framework/text.hpp"

namespace trocar {
namespace {

FaultRecord record_of(const Fault& fault) {
  return {to_string(fault.cause),
          fault.component,
          fault.detail,
          fault.value,
          fault.limit,
          fault.tick,
          static_cast<double>(fault.time_ns) * 1e-9};
}

/// Of all threads, in the order of their time.
std::vector<FaultRecord> faults_of(const std::deque<Executor>& executors) {
  std::vector<FaultRecord> faults;
  for (const Executor& executor : executors)
    for (std::size_t i = 0; i < executor.faults().size(); ++i)
      faults.push_back(record_of(executor.faults()[i]));
  std::stable_sort(faults.begin(), faults.end(),
                   [](const FaultRecord& a, const FaultRecord& b) { return a.time < b.time; });
  return faults;
}

ThreadResult result_of(const Executor& executor) {
  const RateGroup& group = executor.group();
  ThreadResult result{
      .name = group.name(), .rate = 1.0 / group.period(), .loop = executor.statistics()};
  const std::vector<TimingHistogram> times = std::exchange(result.loop.components, {});
  const std::vector<StepCost> costs = std::exchange(result.loop.costs, {});
  result.components.reserve(times.size());  // 8 KiB each
  for (std::size_t i = 0; i < times.size(); ++i)
    result.components.push_back(
        {group.schedule()[i].component->name(), times[i], costs.empty() ? StepCost{} : costs[i]});
  return result;
}

/// Slots within the duration of a run.
std::int64_t slots_of(const RateGroup& group, const std::optional<double>& duration) {
  if (!duration) return -1;
  const double phase = 1e-9 * static_cast<double>(group.phase_ns());
  return std::max<std::int64_t>(0, std::llround((*duration - phase) / group.period()));
}

/// Only what one processor has to do counts, so of each thread alone.
std::string throttling_of(const ThreadResult& thread, double wall_time) {
  if (wall_time <= 0.0) return "";
  const TimingHistogram& ticks = thread.loop.duration;
  const double busy = ticks.mean() * static_cast<double>(ticks.count()) +
                      static_cast<double>(thread.loop.spun_ns);  // [ns]
  return throttling(busy * 1e-9 / wall_time, real_time_share());
}

std::int64_t spin_ns(const RunOptions& options) {
  constexpr double longest = 1e4;  // [s]; far longer than any period
  const double spin = options.timing.spin;
  return std::isnan(spin) ? -1 : std::llround(std::clamp(spin, -longest, longest) * 1e9);
}

/// @throw std::invalid_argument for a name of no signal, with the nearest one
void check_kept(const std::vector<std::string>& keep, const std::vector<RowLayout>& layouts) {
  std::vector<std::string> known;
  for (const RowLayout& layout : layouts)
    for (const RowSignal& signal : layout.signals()) known.push_back(signal.name);
  for (const std::string& name : keep)
    if (std::none_of(known.begin(), known.end(), [&](const std::string& one) {
          return one == name || one.starts_with(name + ".");
        }))
      throw std::invalid_argument(
          fmt::format("keep: the run has no signal \"{}\"{}", name,
                      nearest(name, known).empty() ? "" : suggestion(name, known)));
}

/// @throw std::invalid_argument
void refuse_virtual_time(const WiredGraph& wired) {
  for (const RateGroup& group : wired.groups())
    for (const Device* device : group.devices())
      if (device->needs_real_time())
        throw std::invalid_argument(
            fmt::format("{} is a real device, and virtual time would leave it behind: run it with "
                        "--clock realtime, or with device = \"simulated\"",
                        device->name()));
}

/// @throw std::invalid_argument
void require_pacer(const WiredGraph& wired) {
  for (const RateGroup& group : wired.groups())
    if (pacing_device(group) != nullptr) return;
  throw std::invalid_argument(
      "the clock \"device\": no device of the graph paces a loop by its reports; take realtime or "
      "simulated, or a device = \"hid\"");
}

struct DueReload {
  double at = 0.0;  // [s]
  Reloads::Issued issued;
};

/// All of them before the run, so that a name of no component is found then; in the order of their
/// times.
/// @throw std::invalid_argument
std::deque<DueReload> announce(const std::vector<Reload>& reloads, Reloads& all) {
  std::deque<DueReload> due;
  for (const Reload& reload : reloads) due.push_back({reload.at, all.issue(reload)});
  std::stable_sort(due.begin(), due.end(),
                   [](const DueReload& a, const DueReload& b) { return a.at < b.at; });
  return due;
}

bool all_begun(std::deque<Executor>& executors) {
  return std::all_of(executors.begin(), executors.end(),
                     [](Executor& executor) { return executor.heartbeat().begun(); });
}

}  // namespace

const char* to_string(ClockKind clock) {
  switch (clock) {
    case ClockKind::realtime:
      return "realtime";
    case ClockKind::simulated:
      return "simulated";
    case ClockKind::device:
      return "device";
  }
  return "unknown";
}

std::string check_spin(const RunOptions& options, const Graph& graph) {
  for (NodeId id = 0; id < graph.size(); ++id) {
    const double own = graph.threads()[graph.node(id).thread].rate;
    const double rate = own > 0.0 ? own : options.wiring.rate;
    if (std::string wrong = check_spin(spin_ns(options), std::llround(1e9 / rate)); !wrong.empty())
      return wrong;
  }
  return "";
}

std::string FaultRecord::text() const {
  std::string text = fmt::format("{} in {} at tick {} ({:.3f} s)", cause, component, tick, time);
  if (!detail.empty()) text += ": " + detail;
  if (limit != 0.0) text += fmt::format(", {:.4g} beyond {:.4g}", value, limit);
  return text;
}

RunResult run(const Graph& graph, const RunOptions& options) {
  WiringOptions wiring = options.wiring;
  wiring.virtual_time = options.clock == ClockKind::simulated;
  wiring.reloadable = wiring.reloadable || !options.reloads.empty();
  const std::unique_ptr<WiredGraph> wired = wire(graph, wiring);
  const std::vector<RowLayout> layouts = layouts_of(*wired);
  std::vector<std::vector<Command>> commands = schedule_edits(options.edits, graph, *wired);

  // In virtual time all threads write one ring, in the order in which they run.
  const bool simulated = options.clock == ClockKind::simulated;
  if (simulated) refuse_virtual_time(*wired);
  if (options.clock == ClockKind::device) require_pacer(*wired);
  std::size_t largest = sizeof(Event);
  for (const RowLayout& layout : layouts) largest = std::max(largest, layout.size());
  std::deque<BroadcastRing> rings;
  for (std::size_t i = 0; i < (simulated ? 1 : layouts.size()); ++i)
    rings.emplace_back(ring_capacity(layouts[i], wired->groups()[i].period(), simulated), largest);
  std::vector<RowSink*> sinks = options.sinks;
  std::shared_ptr<RowStore> rows;
  check_kept(options.keep, layouts);
  if (options.keep_rows) sinks.push_back((rows = std::make_shared<RowStore>(options.keep)).get());

  for (std::size_t i = 0; i < layouts.size(); ++i)
    for (const OperatorRequest& request : options.requests)
      commands[i].push_back({.kind = request.kind,
                             .not_before = std::llround(request.at / wired->groups()[i].period())});
  std::deque<CommandQueue> queues(layouts.size());
  Reloads reloads(*wired);
  std::deque<DueReload> to_come = announce(options.reloads, reloads);
  if (simulated)
    for (const auto& [at, issued] : std::exchange(to_come, {}))
      commands[issued.group].push_back(
          {.kind = Command::Kind::reload,
           .not_before = std::llround(at / wired->groups()[issued.group].period()),
           .ticket = issued.ticket});

  StopFlag ended;
  std::deque<Executor> executors;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    const RateGroup& group = wired->groups()[i];
    if (options.engage) commands[i].push_back({.kind = Command::Kind::engage});
    executors.emplace_back(group, ExecutorOptions{.ticks = slots_of(group, options.duration),
                                                  .schedule = std::move(commands[i]),
                                                  .commands = &queues[i],
                                                  .records = &rings[simulated ? 0 : i],
                                                  .layout = &layouts[i],
                                                  .stop = options.stop,
                                                  .end_all = &ended,
                                                  .overload = options.timing.overload,
                                                  .allocations = options.allocations,
                                                  .index = static_cast<std::uint32_t>(i)});
  }
  if (const std::string wrong = check_spin(options, graph); !simulated && !wrong.empty())
    throw std::invalid_argument(wrong);
  std::optional<CpuLatencyHold> hold;
  if (options.timing.hold_latency && !simulated) hold.emplace();

  RowPump pump(rings, sinks, layouts, *wired, simulated);
  RunControl control(graph, wiring, *wired, queues, reloads);
  std::optional<BackgroundPoller> operator_input;
  if ((options.operator_input || !to_come.empty()) && !simulated)
    operator_input.emplace(
        [&] {
          control.flush();
          if (all_begun(executors)) control.begin();
          while (!to_come.empty() && to_come.front().at <= control.time()) {
            control.reload(to_come.front().issued);
            to_come.pop_front();
          }
          if (options.reader_failed)
            for (const ReaderFailure& failure : pump.take_failures())
              options.reader_failed(failure);
          return options.operator_input && options.operator_input(control);
        },
        std::chrono::milliseconds(5));
  const std::int64_t begin = monotonic_ns();
  Shortcomings shortcomings;
  if (simulated)
    run_in_virtual_time(executors);
  else
    shortcomings =
        run_in_real_time(executors, spin_ns(options), options.clock == ClockKind::device);
  const std::int64_t end = monotonic_ns();
  if (operator_input) operator_input->finish();

  PumpResult readers = pump.finish();
  RunResult result{.clock = options.clock};
  for (const Executor& executor : executors) {
    result.threads.push_back(result_of(executor));
    const LoopStatistics& loop = result.threads.back().loop;
    result.duration =
        std::max(result.duration,
                 1e-9 * static_cast<double>(executor.group().phase_ns()) +
                     static_cast<double>(loop.ticks + loop.skipped) * executor.group().period());
  }
  result.faults = faults_of(executors);
  result.reloads = reloads.verdicts();
  result.interrupted = options.stop != nullptr && options.stop->raised();
  result.wall_time = static_cast<double>(end - begin) * 1e-9;
  result.shortcomings = std::move(shortcomings);
  if (!simulated) result.spin = options.timing.spin;
  result.latency_held = hold && hold->held();
  if (hold && !hold->held()) result.shortcomings.push_back(hold->shortcoming());
  for (const ThreadResult& thread : result.threads)
    if (std::string halted = throttling_of(thread, simulated ? 0.0 : result.wall_time);
        !halted.empty())
      result.shortcomings.push_back(std::move(halted));
  result.lost = std::move(readers.failures);
  result.missed = std::move(readers.losses);
  result.rows = std::move(rows);
  return result;
}

}  // namespace trocar
