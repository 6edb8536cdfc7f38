// SPDX-License-Identifier: Apache-2.0
#include "gui/analysis/range_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace trocar::gui {
namespace {

/// The first row behind `time`.
std::uint64_t behind(const Track& track, double time) {
  return track.at(std::nextafter(time, std::numeric_limits<double>::infinity()));
}

}  // namespace

RangeStatistics statistics_of(const SignalRef& signal, double from, double to) {
  RangeStatistics result;
  const Track& track = *signal.track;
  const Column& column = signal.column();
  const std::uint64_t begin = track.at(from), end = behind(track, to);
  Extremes extremes;
  // About the first sample, so that a large offset does not take the deviation's digits.
  double offset = 0.0, sum = 0.0, squares = 0.0;
  for (const std::span<const double> piece : column.pieces(begin, end))
    for (const double value : piece) {
      if (!std::isfinite(value)) continue;
      if (result.count++ == 0) offset = value;
      extremes.add(value);
      sum += value - offset;
      squares += (value - offset) * (value - offset);
    }
  if (result.count == 0) return result;
  const auto n = static_cast<double>(result.count);
  const double shift = sum / n;
  result.min = extremes.min;
  result.max = extremes.max;
  result.mean = offset + shift;
  const double variance = std::max(0.0, squares / n - shift * shift);
  result.deviation = std::sqrt(variance);
  result.rms = std::sqrt(variance + result.mean * result.mean);
  return result;
}

double value_at(const SignalRef& signal, double time) {
  const Track& track = *signal.track;
  const std::uint64_t end = behind(track, time);
  return end > track.first() ? signal.column()[end - 1] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace trocar::gui
