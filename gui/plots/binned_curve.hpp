// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "gui/data/data_store.hpp"

namespace trocar::gui {

/// A signal over time for the eye: of each bin of time, a pixel wide, the least and the greatest,
/// so that what lasted one tick is seen. Bins stand on whole multiples of their width, so that a
/// picture that moves does not shimmer, and what a bin holds is found once.
class BinnedCurve {
 public:
  struct Bin {
    std::int64_t number = 0;  // its time is number × width()
    Extremes extremes;
    bool after_gap = false;  // ticks are missing before it
  };

  /// Shows the signal from `end - span` to `end` [s] in about `bins` bins.
  void show(const SignalRef& signal, double end, double span, int bins);
  void clear();

  double width() const { return width_; }  // [s] of a bin
  const std::deque<Bin>& bins() const { return bins_; }
  Extremes extremes() const;  // of all that is shown

 private:
  void add(const Track& track, const Column& column, std::int64_t number, std::uint64_t row_end);

  const Track* track_ = nullptr;
  std::size_t index_ = 0;
  double width_ = 0.0;
  std::deque<Bin> bins_;
  std::int64_t next_ = 0;       // bin to find
  std::uint64_t next_row_ = 0;  // where it begins
};

}  // namespace trocar::gui
