// SPDX-License-Identifier: Apache-2.0
#include "framework/run.hpp"

#include <fmt/format.h>

#include <cmath>

#include "framework/realtime/cpu_latency_hold.hpp"
#include "framework/realtime/loop_thread.hpp"
#include "framework/realtime/throttling.hpp"
#include "framework/recording/row_pump.hpp"
#include "framework/text.hpp"

namespace trocar {
namespace {

constexpr std::size_t ring_capacity = std::size_t{8} << 20;  // [bytes]: some seconds at 1 kHz

/// The numbers that a value stands for, by the parameter's own rules; the parameter keeps its own.
std::array<double, max_axes> numbers_of(ParameterBase& parameter, const Literal& value,
                                        std::string& wrong) {
  std::array<double, max_axes> numbers{};
  const std::any kept = parameter.save();
  wrong = parameter.set(value);
  const std::span<double> now = parameter.numbers();
  std::copy(now.begin(), now.end(), numbers.begin());
  parameter.restore(kept);
  return numbers;
}

class Scheduler {
 public:
  Scheduler(const Graph& graph, const WiredGraph& wired) : graph_(graph), wired_(wired) {}

  void add(const Edit& edit) {
    const std::size_t dot = std::min(edit.key.rfind('.'), edit.key.size());
    const auto node = graph_.find(edit.key.substr(0, dot));
    const std::string name = dot < edit.key.size() ? edit.key.substr(dot + 1) : "";
    if (!node || graph_.node(*node).settings().find_parameter(name) == nullptr) {
      findings_.add(edit.where, fmt::format("nothing is called \"{}\"{}", edit.key,
                                            suggestion(edit.key, graph_.parameter_keys())));
      return;
    }
    const std::vector<ParameterBase*> moved = wired_.followers(graph_, {*node, name});
    if (moved.empty()) refuse(edit, not_live);
    for (ParameterBase* parameter : moved) add(edit, *parameter);
  }
  void add(const Command& command) { commands_.push_back(command); }
  std::vector<Command> take() {
    if (!findings_.empty()) throw BrokenGraph(findings_);
    return std::move(commands_);
  }

 private:
  void add(const Edit& edit, ParameterBase& parameter) {
    std::string wrong;
    if (!parameter.live() || parameter.numbers().empty()) wrong = not_live;
    Command command{.kind = Command::Kind::set_parameter,
                    .not_before = std::llround(edit.at / wired_.period()),
                    .parameter = &parameter,
                    .owner = "",
                    .target = {}};
    if (wrong.empty()) command.target = numbers_of(parameter, edit.value, wrong);
    for (const ScheduleItem& item : wired_.schedule())
      for (const ParameterBase* own : item.component->parameters())
        if (own == &parameter) command.owner = item.component->name().c_str();
    if (!wrong.empty())
      refuse(edit, wrong);
    else
      commands_.push_back(command);
  }

  void refuse(const Edit& edit, const std::string& why) {
    findings_.add(edit.where, fmt::format("{} = {}: {}", edit.key, edit.value.text(), why));
  }

  static constexpr const char* not_live = "cannot be edited while it runs";
  const Graph& graph_;
  const WiredGraph& wired_;
  Findings findings_;
  std::vector<Command> commands_;
};

FaultRecord record_of(const Fault& fault) {
  return {to_string(fault.cause),
          fault.component,
          fault.detail,
          fault.value,
          fault.limit,
          fault.tick,
          static_cast<double>(fault.time_ns) * 1e-9};
}

RunResult result_of(const Executor& executor, const WiredGraph& graph, const RunOptions& options) {
  RunResult result{.clock = options.clock, .rate = 1.0 / graph.period()};
  if (options.clock == ClockKind::realtime) result.spin = options.timing.spin;
  result.loop = executor.statistics();
  result.duration = static_cast<double>(result.loop.ticks + result.loop.skipped) * graph.period();
  result.interrupted = options.stop != nullptr && options.stop->raised();
  for (std::size_t i = 0; i < graph.schedule().size(); ++i)
    result.components.push_back({graph.schedule()[i].component->name(), result.loop.components[i]});
  for (std::size_t i = 0; i < executor.faults().size(); ++i)
    result.faults.push_back(record_of(executor.faults()[i]));
  return result;
}

std::string throttling_of(const RunResult& result) {
  if (result.clock == ClockKind::simulated || result.wall_time <= 0.0) return "";
  const TimingHistogram& ticks = result.loop.duration;
  const double busy = ticks.mean() * static_cast<double>(ticks.count()) +
                      static_cast<double>(result.loop.spun_ns);  // [ns]
  return throttling(busy * 1e-9 / result.wall_time, real_time_share());
}

std::int64_t spin_ns(const RunOptions& options) {
  constexpr double longest = 1e4;  // [s]; far longer than any period
  const double spin = options.timing.spin;
  return std::isnan(spin) ? -1 : std::llround(std::clamp(spin, -longest, longest) * 1e9);
}

std::unique_ptr<Clock> clock_of(const RunOptions& options) {
  if (options.clock == ClockKind::simulated) return std::make_unique<SimulatedClock>();
  if (const std::string wrong = check_spin(options); !wrong.empty())
    throw std::invalid_argument(wrong);
  return std::make_unique<PeriodicClock>(spin_ns(options));
}

}  // namespace

std::string check_spin(const RunOptions& options) {
  return check_spin(spin_ns(options), std::llround(1e9 / options.wiring.rate));
}

std::string FaultRecord::text() const {
  std::string text = fmt::format("{} in {} at tick {} ({:.3f} s)", cause, component, tick, time);
  if (!detail.empty()) text += ": " + detail;
  if (limit != 0.0) text += fmt::format(", {:.4g} beyond {:.4g}", value, limit);
  return text;
}

RunResult run(const Graph& graph, const RunOptions& options) {
  const std::unique_ptr<WiredGraph> wired = wire(graph, options.wiring);
  const RowLayout layout(*wired);
  Scheduler scheduler(graph, *wired);
  for (const Edit& edit : options.edits) scheduler.add(edit);
  if (options.engage) scheduler.add({.kind = Command::Kind::engage});

  RecordRing ring(std::max(ring_capacity, 64 * layout.size()));
  std::vector<RowSink*> sinks = options.sinks;
  std::shared_ptr<RowStore> rows;
  if (options.keep_rows) sinks.push_back((rows = std::make_shared<RowStore>()).get());

  ExecutorOptions executor_options{.schedule = scheduler.take(),
                                   .records = &ring,
                                   .layout = &layout,
                                   .stop = options.stop,
                                   .overload = options.timing.overload};
  if (options.duration) executor_options.ticks = std::llround(*options.duration / wired->period());
  Executor executor(*wired, executor_options);
  const std::unique_ptr<Clock> clock = clock_of(options);
  std::optional<CpuLatencyHold> hold;
  if (options.timing.hold_latency && !clock->simulated()) hold.emplace();

  RowPump pump(ring, sinks, layout, *wired);
  const std::int64_t begin = monotonic_ns();
  const Shortcomings shortcomings =
      run_on_loop_thread({.realtime = !clock->simulated()}, [&] { executor.run(*clock); });
  const std::int64_t end = monotonic_ns();

  std::vector<std::string> lost = pump.finish();
  RunResult result = result_of(executor, *wired, options);
  result.wall_time = static_cast<double>(end - begin) * 1e-9;
  result.shortcomings = shortcomings;
  result.latency_held = hold && hold->held();
  if (hold && !hold->held()) result.shortcomings.push_back(hold->shortcoming());
  if (std::string halted = throttling_of(result); !halted.empty())
    result.shortcomings.push_back(std::move(halted));
  result.lost = std::move(lost);
  result.rows = std::move(rows);
  return result;
}

}  // namespace trocar
