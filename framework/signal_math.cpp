// SPDX-License-Identifier: Apache-2.0
#include "framework/signal_math.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace trocar {

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  if (n < 2 || y.size() != n) throw std::invalid_argument("a line needs at least two points");
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    mean_x += x[i];
    mean_y += y[i];
  }
  mean_x /= static_cast<double>(n);
  mean_y /= static_cast<double>(n);
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double dx = x[i] - mean_x;
    const double dy = y[i] - mean_y;
    xx += dx * dx;
    yy += dy * dy;
    xy += dx * dy;
  }
  if (!(xx > 0.0)) throw std::invalid_argument("a line needs points that differ in x");
  LineFit fit;
  fit.slope = xy / xx;
  fit.offset = mean_y - fit.slope * mean_x;
  fit.r2 = yy > 0.0 ? xy * xy / (xx * yy) : 1.0;
  fit.inverse_slope = yy > 0.0 ? xy / yy : 0.0;
  fit.rms = std::sqrt(std::max(0.0, yy - fit.slope * xy) / static_cast<double>(n));
  fit.count = n;
  return fit;
}

SignalSummary summarise(std::span<const double> values) {
  if (values.empty()) throw std::invalid_argument("the run has no rows");
  SignalSummary summary{0.0, 0.0, values[0], values[0], values[0], values[values.size() - 1]};
  for (const double value : values) {
    summary.mean += value;
    summary.rms += value * value;
    summary.min = std::min(summary.min, value);
    summary.max = std::max(summary.max, value);
  }
  const double n = static_cast<double>(values.size());
  summary.mean /= n;
  summary.rms = std::sqrt(summary.rms / n);
  return summary;
}

}  // namespace trocar
