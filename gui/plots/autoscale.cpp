// SPDX-License-Identifier: Apache-2.0
#include "gui/plots/autoscale.hpp"

#include <algorithm>

namespace trocar::gui {
namespace {

/// About a tenth of `span`: 1, 2 or 5 times a power of ten.
double round_step(double span) {
  const double power = std::pow(10.0, std::floor(std::log10(span / 10.0)));
  for (const double step : {1.0, 2.0, 5.0})
    if (span / 10.0 <= step * power) return step * power;
  return 10.0 * power;
}

}  // namespace

bool Autoscale::follow(const Extremes& data, double now) {
  Extremes wanted = data;
  wanted.add(always_);
  if (wanted.empty()) return false;
  const double middle = 0.5 * (wanted.min + wanted.max);
  const double least = std::max(1e-9, 1e-6 * std::abs(middle));
  const double span = std::max(wanted.max - wanted.min, least);
  const bool outside = wanted.min < lower_ || wanted.max > upper_;
  const bool small = span < 0.5 * (upper_ - lower_);
  if (!small) small_since_ = -1.0;
  if (small && small_since_ < 0) small_since_ = now;
  if (!outside && !(small && now - small_since_ > shrink_after)) return false;
  const double step = round_step(1.1 * span);
  lower_ = step * std::floor((wanted.min - 0.05 * span) / step);
  upper_ = step * std::ceil((wanted.max + 0.05 * span) / step);
  small_since_ = -1.0;
  return true;
}

}  // namespace trocar::gui
