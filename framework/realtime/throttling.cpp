// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/throttling.hpp"

#include <fmt/format.h>

#include <fstream>

namespace trocar {
namespace {

constexpr double margin = 0.02;  // what the loop's own measurement of its load leaves out

}  // namespace

double real_time_share(const std::string& folder) {
  double runtime = -1.0, period = 0.0;  // [µs]
  std::ifstream(folder + "/sched_rt_runtime_us") >> runtime;
  std::ifstream(folder + "/sched_rt_period_us") >> period;
  return runtime > 0.0 && period > runtime ? runtime / period : 1.0;
}

std::string throttling(double busy, double share) {
  if (share >= 1.0 || busy < share - margin) return "";
  return fmt::format(
      "the loop kept its processor busy for {:.0f} % of the time, and the kernel halts real-time "
      "threads beyond {:.0f} % (sched_rt_runtime_us): shorten the guard spin or the tick",
      100.0 * busy, 100.0 * share);
}

}  // namespace trocar
