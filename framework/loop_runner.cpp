// SPDX-License-Identifier: Apache-2.0
#include "framework/loop_runner.hpp"

#include <algorithm>
#include <vector>

#include "framework/paced_clock.hpp"
#include "framework/supervisor.hpp"

namespace trocar {
namespace {

/// A thread in virtual time.
struct Turn {
  Executor* executor = nullptr;
  std::int64_t next = 0;  // slot

  std::int64_t time_ns() const {
    return executor->group().phase_ns() + next * executor->group().period_ns();
  }
  bool comes_before(const Turn& other) const {
    if (time_ns() != other.time_ns()) return time_ns() < other.time_ns();
    return executor->group().priority() > other.executor->group().priority();
  }
};

/// Those that move devices, and whose overload is to be judged.
Supervisor supervisor_of(std::deque<Executor>& executors) {
  std::vector<Supervisor::Watched> watched;
  for (Executor& executor : executors) {
    const RateGroup& group = executor.group();
    if (group.devices().empty() || executor.overload_policy() == OverloadPolicy::ignore) continue;
    watched.push_back(
        {&executor.heartbeat(), heartbeat_patience(group.period_ns()), group.devices()});
  }
  return Supervisor(std::move(watched));
}

/// However a loop ends, nobody waits for its heart to beat again.
struct EndOfBeating {
  Heartbeat& heartbeat;
  ~EndOfBeating() { heartbeat.end(); }
};

}  // namespace

void run_in_virtual_time(std::deque<Executor>& executors) {
  run_on_loop_thread({}, [&] {
    std::vector<Turn> turns;
    for (Executor& executor : executors) {
      executor.start();
      turns.push_back({&executor});
    }
    while (true) {
      Turn* first = nullptr;
      for (Turn& turn : turns)
        if (!turn.executor->over() && (first == nullptr || turn.comes_before(*first)))
          first = &turn;
      if (first == nullptr) break;
      first->executor->tick({.index = first->next++}, true);
    }
    for (const Turn& turn : turns)
      turn.executor->stop({.index = std::max<std::int64_t>(0, turn.next - 1)}, true);
  });
}

Device* pacing_device(const RateGroup& group) {
  for (Device* device : group.devices())
    if (device->paces()) return device;
  return nullptr;
}

Shortcomings run_in_real_time(std::deque<Executor>& executors, std::int64_t spin_ns, bool paced) {
  std::deque<PeriodicClock> clocks;
  std::vector<LoopThread> threads;
  for (Executor& executor : executors) {
    PeriodicClock& clock = clocks.emplace_back(spin_ns);
    const RateGroup& group = executor.group();
    LoopThread& thread = threads.emplace_back();
    thread.options.name = group.name();
    thread.options.realtime = true;
    thread.options.priority = group.priority();
    thread.options.processor = group.processor();
    thread.prepare = [&executor] { executor.start(); };
    Device* const device = paced ? pacing_device(group) : nullptr;
    thread.loop = [&executor, &clock, &group, device](std::int64_t start_ns) {
      const EndOfBeating end{executor.heartbeat()};
      if (device != nullptr) {
        PacedClock by_device(*device->pacer());
        by_device.start(group.period_ns());
        return executor.loop(by_device);
      }
      clock.start_at(start_ns + group.phase_ns(), group.period_ns());
      executor.loop(clock);
    };
  }
  Supervisor supervisor = supervisor_of(executors);
  if (!supervisor.empty()) {
    LoopThread& thread = threads.emplace_back();
    thread.options.name = "supervisor";
    thread.options.realtime = true;
    for (const Executor& executor : executors)
      thread.options.priority = std::max(thread.options.priority, executor.group().priority() + 1);
    thread.loop = [&supervisor](std::int64_t) {
      MonotonicTime time;
      supervisor.run(time);
    };
  }
  return run_on_loop_threads(threads);
}

}  // namespace trocar
