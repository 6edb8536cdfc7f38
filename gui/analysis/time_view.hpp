// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace trocar::gui {

/// The time about a trigger.
struct Shot {
  double at = 0.0;      // [s] of the trigger
  double before = 0.0;  // [s] shown before it
  double after = 0.0;   // [s] and after it
  bool operator==(const Shot&) const = default;
};

/// A stretch of time, which an axis counts from `zero`.
struct TimeWindow {
  double begin = 0.0, end = 0.0;  // [s]
  double zero = 0.0;              // [s]
};

/// Which time plots show: the newest, what was the newest when they were frozen, or that about a
/// trigger.
struct TimeView {
  double span = 10.0;            // [s]
  std::optional<double> frozen;  // [s] of the right edge
  std::optional<Shot> shot;      // goes before the others

  TimeWindow at(double now) const {
    if (shot) return {shot->at - shot->before, shot->at + shot->after, shot->at};
    const double end = frozen.value_or(now);
    return {end - span, end, end};
  }
};

}  // namespace trocar::gui
