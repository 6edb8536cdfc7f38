// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/workspace_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "components/devices/seeded_random.hpp"

namespace trocar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Place = Eigen::Matrix<double, 5, 1>;  // tip and slopes
using Height = std::function<double(const Place&)>;

/// Whether the tool fits with these slopes and depth, wherever the star's centre is.
bool some_centre_fits(const LaparoscopeReach& reach, const LaparoscopeGeometry& geometry,
                      const LaparoscopeLimits& limits, const Vector2d& slopes, double depth) {
  const double n = std::sqrt(1.0 + slopes.squaredNorm());
  const double k = geometry.tool_length / n - depth;
  const auto margin = [&](const Vector2d& centre) {
    const Vector2d across = centre + k * slopes;
    return reach.margin_at_rest({across.x(), across.y(), geometry.ring_plane + k}, slopes);
  };
  Vector2d at = Vector2d::Zero();
  double best = margin(at);
  for (double step = 0.5 * limits.centre_offset; step > 1e-5 && best < 0.0;) {
    const Vector2d from = at;
    for (int i = 0; i < 8; ++i) {
      const double angle = std::numbers::pi / 4.0 * i;
      const Vector2d there = from + step * Vector2d(std::cos(angle), std::sin(angle));
      if (const double found = margin(there); found > best) {
        best = found;
        at = there;
      }
    }
    if (at == from) step *= 0.5;
  }
  return best >= 0.0;
}

/// Climbs from `start` as far as the limits let it.
double climb(const LaparoscopeReach& reach, Place start, const Place& spans, const Height& height,
             SeededRandom& random) {
  constexpr int levels = 40, trials = 1000;
  double best = height(start);
  double scale = 0.1;
  for (int level = 0; level < levels; ++level, scale *= 0.75)
    for (int trial = 0; trial < trials; ++trial) {
      Place there = start;
      for (Eigen::Index i = 0; i < there.size(); ++i)
        there[i] += scale * spans[i] * random.uniform(-1.0, 1.0);
      if (!(height(there) > best)) continue;
      if (!(reach.margin_at_rest(there.head<3>(), there.tail<2>()) >= 0.0)) continue;
      best = height(there);
      start = there;
    }
  return best;
}

Place place_of(const WorkspacePose& pose) {
  return (Place() << pose.tip, pose.slopes).finished();
}

/// A few, since a climb from one may end in a corner.
std::vector<Place> best_places(const std::vector<WorkspacePose>& poses, const Height& height) {
  const std::size_t starts = std::min<std::size_t>(poses.size(), 5);
  std::vector<Place> places;
  for (const WorkspacePose& pose : poses) places.push_back(place_of(pose));
  const auto middle = places.begin() + static_cast<std::ptrdiff_t>(starts);
  std::partial_sort(places.begin(), middle, places.end(),
                    [&](const Place& a, const Place& b) { return height(a) > height(b); });
  places.resize(starts);
  return places;
}

}  // namespace

double insertion_range(const LaparoscopeGeometry& geometry, const LaparoscopeLimits& limits,
                       double translation) {
  const double e = geometry.base_radius - geometry.platform_radius;
  const double L = geometry.link_length;
  const double farthest = e + translation;  // of a link's ends from each other, seen along n3
  if (!(translation <= limits.centre_offset && farthest <= L * std::sin(limits.link_angle)))
    return 0.0;
  const double steepest = std::sqrt(L * L - (e - translation) * (e - translation));
  const double flattest = std::sqrt(L * L - farthest * farthest);
  const double low =
      std::max(limits.slider_low + steepest, geometry.ring_plane - limits.engagement_high);
  const double high =
      std::min(limits.slider_high + flattest, geometry.ring_plane - limits.engagement_low);
  return std::max(0.0, high - low);
}

double roll_range(const LaparoscopeGeometry& geometry, const LaparoscopeLimits& limits,
                  double translation) {
  return std::max(0.0, limits.ring_travel - std::asin(translation / geometry.ring_radius));
}

double tilt_range(const LaparoscopeGeometry& geometry, const LaparoscopeLimits& limits,
                  double depth) {
  constexpr int directions = 36, halvings = 20;
  const LaparoscopeReach reach(geometry, limits);
  double range = limits.tilt;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2.0 * std::numbers::pi / directions * i;
    const Vector2d direction(std::cos(angle), std::sin(angle));
    const auto fits = [&](double tilt) {
      return some_centre_fits(reach, geometry, limits, std::tan(tilt) * direction, depth);
    };
    if (!fits(0.0)) return std::numeric_limits<double>::quiet_NaN();
    if (fits(range)) continue;
    double low = 0.0, high = range;
    for (int halving = 0; halving < halvings; ++halving)
      (fits(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
    range = low;
  }
  return range;
}

WorkspaceExtent workspace_extent(const WorkspaceSettings& settings,
                                 const std::vector<WorkspacePose>& poses) {
  WorkspaceExtent extent;
  if (poses.empty()) return extent;
  const LaparoscopeReach reach(settings.geometry, settings.limits);
  const auto bounds = reach.bounds();
  const double steepest = std::tan(settings.limits.tilt);
  const Place spans =
      (Place() << bounds.radius, bounds.radius, bounds.high - bounds.low, steepest, steepest)
          .finished();
  SeededRandom random(settings.seed);
  const auto highest = [&](Eigen::Index axis, double sign) {
    const auto height = [axis, sign](const Place& p) { return sign * p[axis]; };
    double best = -std::numeric_limits<double>::infinity();
    for (const Place& start : best_places(poses, height))
      best = std::max(best, climb(reach, start, spans, height, random));
    return best;
  };
  const auto range = [&](Eigen::Index axis) {
    return Range{-highest(axis, -1.0), highest(axis, 1.0)};
  };
  const auto angles = [](const Range& slope) {
    return Range{std::atan(slope.low), std::atan(slope.high)};
  };
  extent.x = range(0);
  extent.y = range(1);
  extent.z = range(2);
  extent.yaw = angles(range(3));
  extent.pitch = angles(range(4));
  return extent;
}

}  // namespace trocar
