// SPDX-License-Identifier: Apache-2.0
#include "gui/plots/autoscale.hpp"

#include <algorithm>

#include "gui/plots/round_step.hpp"

namespace trocar::gui {

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
  const double step = round_step(0.11 * span);
  lower_ = step * std::floor((wanted.min - 0.05 * span) / step);
  upper_ = step * std::ceil((wanted.max + 0.05 * span) / step);
  small_since_ = -1.0;
  return true;
}

}  // namespace trocar::gui
