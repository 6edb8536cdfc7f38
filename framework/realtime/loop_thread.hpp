// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace trocar {

struct LoopThreadOptions {
  bool realtime = false;  // SCHED_FIFO, locked memory, timer slack of 1 ns
  int priority = 80;      // of SCHED_FIFO, 1 to 99
};

/// What the machine did not allow, each with the way to allow it.
using Shortcomings = std::vector<std::string>;

/// Runs `loop` on a thread of its own and waits for it. With `realtime` the thread gets what the
/// machine allows; it runs all the same without. Threads that exist before keep their scheduling,
/// and the loop must not start any. Rethrows what the loop throws.
Shortcomings run_on_loop_thread(const LoopThreadOptions& options,
                                const std::function<void()>& loop);

}  // namespace trocar
