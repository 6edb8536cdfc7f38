// SPDX-License-Identifier: Apache-2.0
#include "cli/bench_loops.hpp"

#include <sched.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <ctime>
#include <fstream>
#include <memory>
#include <optional>

#include "components/register.hpp"
#include "framework/graph.hpp"
#include "framework/realtime/cpu_latency_hold.hpp"
#include "framework/realtime/loop_thread.hpp"

namespace trocar::cli {
namespace {

/// When the first and the last tick happened, on a clock that the loop did not read.
struct Span {
  std::int64_t first_ns = -1;
  std::int64_t last_ns = 0;

  void note(std::int64_t now) RT_SAFE {
    if (first_ns < 0) first_ns = now;
    last_ns = now;
  }
  double periods(std::int64_t period_ns) const {
    return static_cast<double>(last_ns - first_ns) / static_cast<double>(period_ns);
  }
};

class Probe final : public Component {
 public:
  explicit Probe(Span& span) : span_(span) {}
  Input<double> input{this, "input", {.unit = "N", .doc = "what the graph computed"}};
  void step(const Tick&) RT_SAFE override { span_.note(monotonic_ns()); }

 private:
  Span& span_;
};

std::int64_t locked_kib() {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;)
    if (std::int64_t amount = -1; word == "VmLck:" && file >> amount) return amount;
  return -1;
}

LoopGrants grants_here() {
  LoopGrants grants;
  sched_param param{};
  grants.fifo = sched_getscheduler(0) == SCHED_FIFO;
  if (sched_getparam(0, &param) == 0) grants.priority = param.sched_priority;
  grants.timer_slack_ns = prctl(PR_GET_TIMERSLACK);
  grants.locked_kib = locked_kib();
  return grants;
}

/// Written out on its own, and not with Trocar's clock, or it would be no yardstick.
void bare_loop(const LoopTask& task, std::int64_t period_ns, LoopRound& round, Span& span) {
  const std::int64_t slots = std::llround(task.duration * task.rate);
  const std::int64_t spin_ns = std::llround(task.timing.spin * 1e9);
  std::int64_t spun_ns = 0;
  const std::int64_t start = monotonic_ns();
  for (std::int64_t k = 0; k < slots && !task.stop->raised();) {
    const std::int64_t due = start + k * period_ns;
    const timespec date{(due - spin_ns) / 1'000'000'000, (due - spin_ns) % 1'000'000'000};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &date, nullptr) == EINTR) {
    }
    std::int64_t now = monotonic_ns();
    const std::int64_t awake = now;
    while (now < due) now = monotonic_ns();
    spun_ns += now - awake;
    const std::int64_t late = now - due;
    round.lateness.add(late);
    span.note(now);
    ++round.used;
    const std::int64_t lost = std::min(late / period_ns, slots - k - 1);
    round.skipped += lost;
    k += 1 + lost;
  }
  const double elapsed = static_cast<double>(std::max<std::int64_t>(1, monotonic_ns() - start));
  round.spun = static_cast<double>(spun_ns) / elapsed;
}

/// @param inside [ns] from a tick's beginning to where its time was taken, at most
void finish(LoopRound& round, const Span& span, const LoopTask& task, std::int64_t period_ns,
            std::int64_t inside) {
  round.elapsed = span.periods(period_ns);
  round.uncertainty =
      static_cast<double>(round.lateness.max() + inside) / static_cast<double>(period_ns);
  round.complete = !task.stop->raised();
}

std::int64_t period_of(const LoopTask& task) {
  return std::llround(1e9 / task.rate);
}

}  // namespace

bool LoopRound::adds_up() const {
  return std::abs(drift()) <= uncertainty;
}

LoopRound bare_round(const LoopTask& task, LoopGrants& grants) {
  LoopRound round;
  Span span;
  std::optional<CpuLatencyHold> hold;
  if (task.timing.hold_latency) hold.emplace();
  round.shortcomings = run_on_loop_thread({.realtime = true}, [&] {
    grants = grants_here();
    bare_loop(task, period_of(task), round, span);
  });
  if (hold && !hold->held()) round.shortcomings.push_back(hold->shortcoming());
  finish(round, span, task, period_of(task), 0);
  return round;
}

LoopRound trocar_round(const LoopTask& task) {
  Span span;
  Registry registry;
  register_components(registry);
  registry.add({"Probe",
                "bench",
                "notes when it is stepped",
                [&] { return std::make_unique<Probe>(span); },
                {}});
  Graph graph(registry);
  const Where here{"bench", 0};
  const NodeId sine = graph.add("Sine", "sine", here).value();
  const NodeId scale = graph.add("Scale", "scale", here).value();
  const NodeId probe = graph.add("Probe", "probe", here).value();
  graph.set({sine, "amplitude"}, literal_from_text("1 N"), here);
  graph.set({scale, "factor"}, literal_from_text("2"), here);
  graph.connect({sine, "value"}, {scale, "input"}, here);
  graph.connect({scale, "value"}, {probe, "input"}, here);

  RunOptions options{.timing = task.timing, .duration = task.duration, .stop = task.stop};
  options.timing.overload.policy = OverloadPolicy::ignore;
  options.wiring.rate = task.rate;
  const RunResult result = run(graph, options);

  LoopRound round;
  round.lateness = result.main().loop.lateness;
  round.used = result.main().loop.ticks;
  round.skipped = result.main().loop.skipped;
  round.spun = static_cast<double>(result.main().loop.spun_ns) * 1e-9 / result.wall_time;
  round.shortcomings = result.shortcomings;
  finish(round, span, task, period_of(task), result.main().loop.duration.max());
  return round;
}

}  // namespace trocar::cli
