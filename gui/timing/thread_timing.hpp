// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "framework/realtime/timing_histogram.hpp"
#include "gui/data/track.hpp"

namespace trocar::gui {

/// How punctual a thread is and what its ticks cost, of all rows that were seen since the
/// beginning, or since forget(). Rows are taken bit by bit, so that a long log does not hold up the
/// window.
class ThreadTiming {
 public:
  struct Component {
    std::string name;  // as in the rows: dots are underscores
    std::size_t column = 0;
    TimingHistogram steps{};  // [ns] of the ticks in which it was due
  };

  /// @param period [s], 0: found from the rows
  ThreadTiming(const Track& track, double period);

  /// Takes at most `most` rows that are shown and not taken yet. Where what is shown ends before
  /// what was taken, it begins anew. @return whether all are taken
  bool take(std::uint64_t most);
  void forget();

  const std::string& name() const { return track_.name(); }
  const Track& track() const { return track_; }
  double period() const { return period_; }  // [s], 0 where it is not known
  std::uint64_t ticks() const { return lateness_.count(); }
  const TimingHistogram& lateness() const { return lateness_; }  // [ns]
  const TimingHistogram& duration() const { return duration_; }  // [ns]
  std::uint64_t missed_slots() const { return missed_slots_; }   // that the loop skipped
  std::uint64_t missing_rows() const { return missing_rows_; }   // that did not come
  std::uint64_t overloads() const { return overloads_; }  // ticks that took longer than the period
  /// [ns] that the longest tick left of the period; negative when it took longer.
  double least_margin() const;
  const std::vector<Component>& components() const { return components_; }
  /// Nothing took any time: times are 0 in virtual time.
  bool all_zero() const { return ticks() > 0 && duration_.max() == 0 && lateness_.max() == 0; }

 private:
  void take_row(std::uint64_t row);
  void find_period();

  const Track& track_;
  double declared_;
  double period_ = 0.0;
  std::size_t lateness_column_ = 0, duration_column_ = 0, flags_column_ = 0;
  bool has_times_ = false;
  std::uint64_t next_ = 0;  // row
  std::int64_t last_tick_ = -1;
  TimingHistogram lateness_, duration_;
  std::uint64_t missed_slots_ = 0, missing_rows_ = 0, overloads_ = 0;
  std::vector<Component> components_;
};

}  // namespace trocar::gui
