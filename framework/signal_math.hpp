// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace trocar {

/// A least-squares line through points, y = slope x + offset.
struct LineFit {
  double slope = 0.0;
  double offset = 0.0;
  double r2 = 0.0;             // share of the variance of y that the line explains
  double inverse_slope = 0.0;  // of x on y: dx/dy of its own least-squares line
  double rms = 0.0;            // of the residuals in y
  std::size_t count = 0;
};

/// @throw std::invalid_argument when fewer than two points differ in x.
LineFit fit_line(std::span<const double> x, std::span<const double> y);

struct SignalSummary {
  double mean = 0.0;
  double rms = 0.0;
  double min = 0.0;
  double max = 0.0;
  double first = 0.0;
  double last = 0.0;
};

/// @throw std::invalid_argument when there are no values.
SignalSummary summarise(std::span<const double> values);

}  // namespace trocar
