// SPDX-License-Identifier: Apache-2.0
#include "gui/device/workspace_outline.hpp"

#include <QElapsedTimer>
#include <cmath>
#include <numbers>

namespace trocar::gui {
namespace {

using Eigen::Vector3d;

constexpr int around = 6 * (WorkspaceOutline::directions - 1);  // steps of a whole turn
constexpr double step_angle = 2.0 * std::numbers::pi / around;

/// The direction from 0 to 60 deg that stands for the n-th of a whole turn.
int representative(int n) {
  const int third = around / 3, m = n % third;
  return m < WorkspaceOutline::directions ? m : third - m;
}

}  // namespace

WorkspaceOutline::WorkspaceOutline(const LaparoscopeGeometry& geometry,
                                   const LaparoscopeLimits& limits)
    : reach_(geometry, limits),
      bounds_(reach_.bounds()),
      radii_(static_cast<std::size_t>(directions * levels), 0.0) {}

double WorkspaceOutline::height(int level) const {
  return std::lerp(bounds_.low, bounds_.high, level / (levels - 1.0));
}

double WorkspaceOutline::radius(int level, int direction) const {
  return radii_[static_cast<std::size_t>(level * directions + direction)];
}

bool WorkspaceOutline::advance(double milliseconds) {
  QElapsedTimer clock;
  clock.start();
  while (!complete()) {
    radii_[static_cast<std::size_t>(next_)] =
        search(height(next_ / directions), step_angle * (next_ % directions));
    ++next_;
    if (1e-6 * static_cast<double>(clock.nsecsElapsed()) >= milliseconds) break;
  }
  return complete();
}

/// From the bounds inwards until a tip is reached, then to 0.5 mm between the last two.
double WorkspaceOutline::search(double height, double direction) const {
  const auto reaches = [&](double radius) {
    return reach_.reaches({radius * std::cos(direction), radius * std::sin(direction), height});
  };
  constexpr int steps = 16;
  for (int i = steps - 1; i >= 0; --i) {
    double inside = bounds_.radius * i / steps;
    if (!reaches(inside)) continue;
    double outside = bounds_.radius * (i + 1) / steps;
    while (outside - inside > 0.0005) {
      const double middle = 0.5 * (inside + outside);
      (reaches(middle) ? inside : outside) = middle;
    }
    return inside;
  }
  return 0.0;
}

std::vector<std::vector<Vector3d>> WorkspaceOutline::paths() const {
  std::vector<std::vector<Vector3d>> paths;
  const int found = next_ / directions;  // levels that are done
  const auto at = [&](int level, int n) -> Vector3d {
    const double radius = this->radius(level, representative(n % around));
    return {radius * std::cos(n * step_angle), radius * std::sin(n * step_angle), height(level)};
  };
  for (int level = 0; level < found; level += 4) {
    std::vector<Vector3d> section;
    for (int n = 0; n <= around; ++n) section.push_back(at(level, n));
    if (radius(level, 0) > 0.0) paths.push_back(std::move(section));
  }
  for (int n = 0; n < around; n += around / 6) {
    std::vector<Vector3d> meridian;
    for (int level = 0; level < found; ++level)
      if (radius(level, representative(n)) > 0.0) meridian.push_back(at(level, n));
    if (meridian.size() > 1) paths.push_back(std::move(meridian));
  }
  return paths;
}

}  // namespace trocar::gui
