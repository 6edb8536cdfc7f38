// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "gui/data/data_store.hpp"

namespace trocar::gui {

/// Of a signal's samples x₁ … xₙ over a stretch of time, in its unit; NaN without samples. What is
/// not a number does not count.
struct RangeStatistics {
  std::uint64_t count = 0;
  double min = std::numeric_limits<double>::quiet_NaN();
  double max = std::numeric_limits<double>::quiet_NaN();
  double mean = std::numeric_limits<double>::quiet_NaN();       // Σ x / n
  double rms = std::numeric_limits<double>::quiet_NaN();        // √(Σ x² / n)
  double deviation = std::numeric_limits<double>::quiet_NaN();  // √(Σ (x − mean)² / n)
};

/// @param from, to [s], both included
RangeStatistics statistics_of(const SignalRef& signal, double from, double to);

/// Of the newest row at or before `time` [s]; NaN when there is none.
double value_at(const SignalRef& signal, double time);

}  // namespace trocar::gui
