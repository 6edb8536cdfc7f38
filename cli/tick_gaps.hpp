// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace trocar::cli {

/// Counts what is missing between the ticks of a channel's rows. Rows of one rate group are an
/// integer number of ticks apart; the smallest distance seen is taken for it.
class TickGaps {
 public:
  /// @param skipped the loop itself left out slots before this row, so nothing was lost there
  void add(std::int64_t tick, std::int64_t time_ns, bool skipped);

  std::uint64_t rows_lost() const { return missing(lost_); }
  std::uint64_t slots_skipped() const { return missing(skipped_); }
  std::uint64_t gaps() const;                     // in which rows were lost
  std::optional<std::int64_t> first_gap() const;  // the tick of the row before it
  std::uint64_t runs() const { return runs_; }    // ticks began anew that often
  double rate() const;                            // [Hz] of the rows, 0 where unknown
  double duration() const;                        // [s], the last row's slot included

 private:
  using Distances = std::map<std::int64_t, std::uint64_t>;  // [ticks], how often
  std::int64_t step() const;                                // [ticks] from row to row
  std::uint64_t missing(const Distances& distances) const;

  Distances lost_, skipped_;
  std::map<std::int64_t, std::int64_t> first_tick_;  // before a distance [ticks]
  std::int64_t tick_ = 0, time_ns_ = 0;
  double ticks_spanned_ = 0.0;
  double time_spanned_ = 0.0;  // [s]
  std::uint64_t runs_ = 0;
};

}  // namespace trocar::cli
