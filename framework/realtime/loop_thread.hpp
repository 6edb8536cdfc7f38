// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trocar {

struct LoopThreadOptions {
  std::string name = "loop";
  bool realtime = false;           // SCHED_FIFO, locked memory, timer slack of 1 ns
  int priority = 80;               // of SCHED_FIFO, 1 to 99
  std::optional<int> processor{};  // that it keeps to, with `realtime`
};

/// One of several threads that run side by side.
struct LoopThread {
  LoopThreadOptions options{};
  std::function<void()> prepare;                    // on the thread, before any of them begins
  std::function<void(std::int64_t start_ns)> loop;  // all from one date of CLOCK_MONOTONIC
};

/// What the machine did not allow, each with the way to allow it.
using Shortcomings = std::vector<std::string>;

/// Runs each on a thread of its own and waits for all. They begin when the last one is prepared;
/// none does when one of them cannot be. Scheduling as below. Rethrows the first of what they
/// throw.
Shortcomings run_on_loop_threads(const std::vector<LoopThread>& threads);

/// Runs `loop` on a thread of its own and waits for it. With `realtime` the thread gets what the
/// machine allows; it runs all the same without. Threads that exist before keep their scheduling,
/// and the loop must not start any. Rethrows what the loop throws.
Shortcomings run_on_loop_thread(const LoopThreadOptions& options,
                                const std::function<void()>& loop);

}  // namespace trocar
