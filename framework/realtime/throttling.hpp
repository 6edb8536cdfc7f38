// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace trocar {

/// The part of a processor that real-time threads may take before the kernel halts them for the
/// rest of a second: sched_rt_runtime_us / sched_rt_period_us; 1 where it sets no limit, or says
/// nothing.
double real_time_share(const std::string& folder = "/proc/sys/kernel");

/// "" when a loop that keeps a processor busy for `busy` (0 to 1) of the time stays clear of that
/// limit, else what happens and the cure.
std::string throttling(double busy, double share);

}  // namespace trocar
