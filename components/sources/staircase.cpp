// SPDX-License-Identifier: Apache-2.0
#include "components/sources/staircase.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace trocar {

int LoadCourse::level(int dwell) const RT_SAFE {
  const int half = (levels - 1) / 2;
  if (dwell <= 0 || dwell >= 4 * half) return 0;
  if (dwell <= half) return dwell;
  return dwell <= 3 * half ? 2 * half - dwell : dwell - 4 * half;
}

LoadCourse::Point LoadCourse::at(double t) const RT_SAFE {
  if (!(t >= 0.0 && t < duration)) return {};
  const double dwells_done = t / duration * dwells();
  const int dwell = std::min(static_cast<int>(dwells_done), dwells() - 1);
  const double share = dwells_done - dwell;
  const double moved = share < ramp ? 0.5 * (1.0 - std::cos(std::numbers::pi * share / ramp)) : 1.0;
  const double newton = peak / ((levels - 1) / 2);
  const double before = newton * level(dwell - 1);
  return {before + moved * (newton * level(dwell) - before), share >= 0.75};
}

Staircase::Staircase() {
  place({.force = &force, .acts = Placement::Acts::on_tool});
}

void Staircase::configure(const Setup&) {
  if (*levels % 2 == 0)
    throw std::invalid_argument(
        fmt::format("levels = {}: needs an odd number, so that 0 N is a level; take {} or {}",
                    *levels, *levels == 2 ? 3 : *levels - 1, *levels == 2 ? 5 : *levels + 1));
  course_ = {*peak, static_cast<int>(*levels), *duration, *ramp};
}

void Staircase::step(const Tick& tick) RT_SAFE {
  const LoadCourse::Point point = course_.at(tick.time);
  *load = point.load;
  *settled = point.settled;
  *force = Eigen::Vector3d(point.load * Eigen::Vector3d::Unit(axis->index));
}

}  // namespace trocar
