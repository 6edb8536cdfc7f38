// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gui/data/extremes.hpp"

namespace trocar::gui {

/// The range of an axis that follows its data without twitching: it grows at once, to round
/// numbers, and shrinks only when less than half of it has been used for some seconds.
class Autoscale {
 public:
  static constexpr double shrink_after = 3.0;  // [s]

  /// @param now [s] @return whether the range changed
  bool follow(const Extremes& data, double now);
  /// Values that are always within the range: 0, a cap.
  void include(double value) { always_.add(value); }
  double lower() const { return lower_; }
  double upper() const { return upper_; }

 private:
  Extremes always_;
  double lower_ = 0.0, upper_ = 0.0;
  double small_since_ = -1.0;
};

}  // namespace trocar::gui
