// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_geometry.hpp"
#include "components/kinematics/matrices.hpp"
#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// Whether the tool's tip can be somewhere at all, in some orientation, inside all limits.
///
/// A tool is given by its tip E and the slopes s = (t1/t3, t2/t3) of its axis. With n = |(s, 1)|
/// and k = E3 - zt, the height of the tip above the ring plane,
///
///   A = E - l/n (s, 1),   centre c = E12 - k s,   engagement M = l - k n
///
/// The limits on tilt, M and c leave a ring of slopes about 0, cut by a disc about E12/k. There, in
/// the coordinates (radius, angle) of that cut ring, the largest margin of the delta is looked for:
/// first on a grid, then by a compass search from its best points.
class LaparoscopeReach {
 public:
  /// A cylinder about n3 that no reachable tip is outside of.
  struct Bounds {
    double radius;  // [m]
    double low;     // [m]
    double high;    // [m]
    double volume() const RT_SAFE;
  };

  /// @throw std::invalid_argument when geometry or limits cannot be.
  LaparoscopeReach(const LaparoscopeGeometry& geometry, const LaparoscopeLimits& limits);

  /// Distance to the nearest limit, the rings' travel left out; negative outside. [m], an angle
  /// counts by the length that it moves a link's or the tool's end.
  double margin(const Eigen::Vector3d& tip, const Eigen::Vector2d& slopes) const RT_SAFE;
  /// The same with the rings at theta = 0, from where they have most room.
  double margin_at_rest(const Eigen::Vector3d& tip, const Eigen::Vector2d& slopes) const RT_SAFE;

  /// Some slopes have a margin, the rings at theta = 0.
  bool reaches(const Eigen::Vector3d& tip) const RT_SAFE;

  Bounds bounds() const RT_SAFE;

 private:
  struct Slopes;  // the cut ring of one tip

  double delta_margin(const Eigen::Vector3d& ball) const RT_SAFE;
  Slopes slopes_for(const Eigen::Vector3d& tip) const RT_SAFE;
  bool climbs_inside(const Eigen::Vector3d& tip, const Slopes& slopes, Eigen::Vector2d at,
                     double margin) const RT_SAFE;

  LaparoscopeGeometry geometry_;
  LaparoscopeLimits limits_;
  double steepest_;      // tan(tilt)
  double link_lateral_;  // L sin(link_angle) [m]
};

}  // namespace trocar
