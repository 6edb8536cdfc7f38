// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "components/kinematics/three_phases.hpp"

namespace trocar {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// In coordinates u in [0, 1], from the flattest slope to the steepest, and v in [-1, 1], from one
/// end of the arc to the other.
struct LaparoscopeReach::Slopes {
  bool empty = true;
  double low = 0.0, high = 0.0;  // |s|
  double away = 0.0;             // |E12| [m]
  Vector2d outwards{1.0, 0.0};   // E12/|E12|
  double k = 0.0;                // [m]
  double offset = 0.0;           // largest |c| [m]

  Vector2d at(double u, double v) const RT_SAFE {
    const double s = low + u * (high - low);
    const double twice = 2.0 * away * k * s;
    double half_arc = std::numbers::pi;
    if (twice > 0.0)
      half_arc =
          std::acos(std::clamp((away * away + k * k * s * s - offset * offset) / twice, -1.0, 1.0));
    const double x = s * std::cos(v * half_arc), y = s * std::sin(v * half_arc);
    return {x * outwards.x() - y * outwards.y(), x * outwards.y() + y * outwards.x()};
  }
};

LaparoscopeReach::LaparoscopeReach(const LaparoscopeGeometry& geometry,
                                   const LaparoscopeLimits& limits)
    : geometry_(geometry),
      limits_(limits),
      steepest_(std::tan(limits.tilt)),
      link_lateral_(geometry.link_length * std::sin(limits.link_angle)) {
  validate(geometry);
  validate(limits, geometry);
}

double LaparoscopeReach::Bounds::volume() const RT_SAFE {
  return std::numbers::pi * radius * radius * (high - low);
}

LaparoscopeReach::Bounds LaparoscopeReach::bounds() const RT_SAFE {
  const double longest = geometry_.tool_length - limits_.engagement_low;  // from B to E
  const double shortest = geometry_.tool_length - limits_.engagement_high;
  return {.radius = limits_.centre_offset + longest * std::sin(limits_.tilt),
          .low = geometry_.ring_plane + shortest * std::cos(limits_.tilt),
          .high = geometry_.ring_plane + longest};
}

double LaparoscopeReach::delta_margin(const Vector3d& ball) const RT_SAFE {
  const double e = geometry_.base_radius - geometry_.platform_radius;
  const double square = geometry_.link_length * geometry_.link_length;
  double margin = link_lateral_;
  for (int i = 0; i < 3; ++i) {
    const double x = ball.x() - e * phase_cos[i];
    const double y = ball.y() - e * phase_sin[i];
    const double lateral = x * x + y * y;
    const double slider = ball.z() - std::sqrt(std::max(0.0, square - lateral));
    margin = std::min({margin, link_lateral_ - std::sqrt(lateral), slider - limits_.slider_low,
                       limits_.slider_high - slider});
  }
  return margin;
}

double LaparoscopeReach::margin(const Vector3d& tip, const Vector2d& slopes) const RT_SAFE {
  const double l = geometry_.tool_length;
  const double n = std::sqrt(1.0 + slopes.squaredNorm());
  const double k = tip.z() - geometry_.ring_plane;
  const double engagement = l - k * n;
  const Vector3d ball = tip - l / n * Vector3d(slopes.x(), slopes.y(), 1.0);
  const Vector2d centre = tip.head<2>() - k * slopes;
  return std::min({delta_margin(ball), engagement - limits_.engagement_low,
                   limits_.engagement_high - engagement, limits_.centre_offset - centre.norm(),
                   l * (steepest_ - slopes.norm())});
}

double LaparoscopeReach::margin_at_rest(const Vector3d& tip, const Vector2d& slopes) const RT_SAFE {
  const double inside = margin(tip, slopes);
  if (limits_.ring_travel >= std::numbers::pi / 2) return inside;  // eps_i stays below 90 deg
  const Vector2d centre = tip.head<2>() - (tip.z() - geometry_.ring_plane) * slopes;
  double across = 0.0;  // r sin eps_i = n_i·c
  for (int i = 0; i < 3; ++i)
    across = std::max(across, std::abs(centre.y() * phase_cos[i] - centre.x() * phase_sin[i]));
  return std::min(inside, geometry_.ring_radius * std::sin(limits_.ring_travel) - across);
}

LaparoscopeReach::Slopes LaparoscopeReach::slopes_for(const Vector3d& tip) const RT_SAFE {
  Slopes s;
  s.k = tip.z() - geometry_.ring_plane;
  s.offset = limits_.centre_offset;
  const double steepest = (geometry_.tool_length - limits_.engagement_low) / s.k;   // n
  const double flattest = (geometry_.tool_length - limits_.engagement_high) / s.k;  // n
  // M never exceeds l, so a tip at or below the ring plane is out of reach.
  if (!(s.k > 0.0 && steepest >= 1.0)) return s;
  s.away = tip.head<2>().norm();
  if (s.away > 0.0) s.outwards = tip.head<2>() / s.away;
  s.low = std::max(flattest > 1.0 ? std::sqrt(flattest * flattest - 1.0) : 0.0,
                   (s.away - s.offset) / s.k);
  s.high = std::min({std::sqrt(steepest * steepest - 1.0), steepest_, (s.away + s.offset) / s.k});
  s.empty = !(s.low <= s.high);
  return s;
}

bool LaparoscopeReach::climbs_inside(const Vector3d& tip, const Slopes& slopes, Vector2d at,
                                     double margin) const RT_SAFE {
  constexpr double shortest_step = 1.0 / 512;
  static constexpr std::array<std::array<double, 2>, 8> compass{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
  for (double step = 0.125; step >= shortest_step;) {
    bool better = false;
    for (const auto& [du, dv] : compass) {
      const Vector2d there(std::clamp(at.x() + step * du, 0.0, 1.0),
                           std::clamp(at.y() + 2.0 * step * dv, -1.0, 1.0));
      const double found = margin_at_rest(tip, slopes.at(there.x(), there.y()));
      if (found >= 0.0) return true;
      if (!(found > margin)) continue;
      margin = found;
      at = there;
      better = true;
    }
    if (!better) step *= 0.5;
  }
  return false;
}

bool LaparoscopeReach::reaches(const Vector3d& tip) const RT_SAFE {
  constexpr int rows = 4, columns = 8, starts = 3;
  const Slopes slopes = slopes_for(tip);
  if (slopes.empty) return false;
  struct Start {
    double margin = -1e9;
    Vector2d at = Vector2d::Zero();
  };
  std::array<Start, starts> best{};
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= columns; ++j) {
      const Vector2d at(i / double{rows}, 2.0 * j / double{columns} - 1.0);
      const double margin = margin_at_rest(tip, slopes.at(at.x(), at.y()));
      if (margin >= 0.0) return true;
      if (!(margin > best.back().margin)) continue;
      best.back() = {margin, at};
      for (std::size_t k = best.size() - 1; k > 0 && best[k].margin > best[k - 1].margin; --k)
        std::swap(best[k], best[k - 1]);
    }
  return std::any_of(best.begin(), best.end(), [&](const Start& start) {
    return climbs_inside(tip, slopes, start.at, start.margin);
  });
}

}  // namespace trocar
