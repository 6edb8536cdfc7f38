// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>

#include "framework/executor.hpp"
#include "framework/realtime/loop_thread.hpp"

namespace trocar {

/// Runs all threads of a graph one after the other, each at its virtual times, in one order: time,
/// then priority (the higher first), then declaration. As fast as the machine goes.
void run_in_virtual_time(std::deque<Executor>& executors);

/// Runs each on a thread of the machine of its own, all on one raster of time.
/// @param spin_ns guard spin of each, see PeriodicClock
/// @param paced where a thread has a device that paces, its reports begin the ticks
/// @return what the machine did not allow
Shortcomings run_in_real_time(std::deque<Executor>& executors, std::int64_t spin_ns,
                              bool paced = false);

/// The first device of a thread that paces, or nullptr.
Device* pacing_device(const RateGroup& group);

}  // namespace trocar
