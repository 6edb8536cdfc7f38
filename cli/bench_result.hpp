// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/bench_loops.hpp"
#include "cli/machine.hpp"

namespace trocar::cli {

/// The rounds of both loops at one rate, pair by pair.
struct RateRounds {
  double rate = 0.0;  // [Hz]
  std::vector<LoopRound> bare{};
  std::vector<LoopRound> trocar{};
};

/// What `trocar bench` measured, and where.
struct BenchResult {
  int rounds_wanted = 0;
  double round_time = 0.0;  // [s]
  LoopTiming timing{};
  std::vector<RateRounds> rates{};
  std::vector<MachineFact> machine{};
  LoopGrants grants{};
  std::string load;                         // while it was measured
  std::vector<std::string> shortcomings{};  // of the machine, each once
  bool interrupted = false;

  bool empty() const;
};

/// The figures that are told of a loop's lateness.
struct LatenessFigure {
  const char* label;
  const char* key;
  double share;  // of all ticks that were not later; 1: the worst
};
inline constexpr std::array<LatenessFigure, 4> lateness_figures{{{"median", "p50", 0.5},
                                                                 {"99 %", "p99", 0.99},
                                                                 {"99.9 %", "p999", 0.999},
                                                                 {"worst", "max", 1.0}}};

/// [s] of one figure over the rounds.
struct OverRounds {
  double median = 0.0;
  double least = 0.0;
  double greatest = 0.0;
};
OverRounds over_rounds(const std::vector<LoopRound>& rounds, double share);

/// Trocar's figure over the bare loop's, pair by pair. What the machine does meanwhile meets both
/// loops of a pair, and mostly cancels.
struct PairRatio {
  double median = 0.0;
  /// The 95 % interval of that median, by the ranks of a sign test: whatever the distribution, the
  /// true median lies in it with at least that probability. Absent below 6 pairs.
  std::optional<std::pair<double, double>> interval{};
};
/// Absent where nothing can be said: no pair, or a bare loop that was late by less than 1 us, most
/// of which is the reading of the clock.
std::optional<PairRatio> ratio_over_pairs(const RateRounds& rounds, double share);

/// All rounds of one loop together.
struct LoopTotal {
  TimingHistogram lateness{};
  std::int64_t used = 0;  // slots
  std::int64_t skipped = 0;
  double spun = 0.0;    // of a processor, mean
  double drift = 0.0;   // [periods] by which elapsed time differs from the slots, the largest
  bool adds_up = true;  // in each round
};
LoopTotal total_of(const std::vector<LoopRound>& rounds);

/// In words, for an operator.
std::string bench_text(const BenchResult& result);
/// For programs. Times in s, rates in Hz.
std::string bench_json(const BenchResult& result);
/// Histograms of all rounds: loop,rate_hz,lower_ns,upper_ns,count; both edges belong to the bin.
std::string bench_csv(const BenchResult& result);

}  // namespace trocar::cli
