// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "framework/run.hpp"

namespace trocar::cli {

/// What a loop did in one round.
struct LoopRound {
  TimingHistogram lateness{};
  std::int64_t used = 0;  // slots
  std::int64_t skipped = 0;
  double elapsed = 0.0;      // [periods] from the first slot's tick to the last one's, measured
  double uncertainty = 0.0;  // [periods] of that, from the lateness of the two
  double spun = 0.0;         // of a processor, 0 to 1
  std::vector<std::string> shortcomings{};
  bool complete = false;  // not interrupted

  /// [periods] between elapsed time and the slots used and skipped.
  double drift() const { return elapsed - static_cast<double>(used + skipped - 1); }
  /// Elapsed time over the period is slots used and skipped: the loop has not drifted.
  bool adds_up() const;
};

/// What the kernel says that a loop's thread was given.
struct LoopGrants {
  bool fifo = false;
  int priority = 0;
  std::int64_t timer_slack_ns = -1;
  std::int64_t locked_kib = -1;  // memory
};

struct LoopTask {
  double rate = 1000.0;   // [Hz]
  double duration = 2.0;  // [s]
  LoopTiming timing{};
  const StopFlag* stop = nullptr;
};

/// The least that a periodic loop can be: clock_nanosleep to absolute dates, one reading of the
/// clock, one entry in a histogram; on the same kind of thread as Trocar's.
LoopRound bare_round(const LoopTask& task, LoopGrants& grants);

/// Trocar's own loop by run(): commands, a small graph, gates, a row for each tick, timing.
LoopRound trocar_round(const LoopTask& task);

}  // namespace trocar::cli
