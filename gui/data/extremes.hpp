// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

namespace trocar::gui {

/// The least and the greatest of some samples; what is not a number does not count.
struct Extremes {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  bool empty() const { return !(min <= max); }
  void add(double value) {
    if (value < min) min = value;
    if (value > max) max = value;
  }
  void add(const Extremes& other) {
    if (other.min < min) min = other.min;
    if (other.max > max) max = other.max;
  }
};

}  // namespace trocar::gui
