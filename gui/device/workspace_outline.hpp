// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "components/kinematics/laparoscope_reach.hpp"

namespace trocar::gui {

/// The outline of where the laparoscope's tip reaches in some orientation: how far from n3, at some
/// heights and in some directions. It is found bit by bit, so that who draws it can go on.
///
/// The three arms stand 120 deg apart and each is its own mirror image: directions of 0 to 60 deg
/// stand for all.
class WorkspaceOutline {
 public:
  static constexpr int directions = 5;  // over 60 deg, both ends included
  static constexpr int levels = 25;     // heights, from the lowest tip to the highest

  /// @throw std::invalid_argument when geometry or limits cannot be.
  WorkspaceOutline(const LaparoscopeGeometry& geometry, const LaparoscopeLimits& limits);

  /// Searches on for `milliseconds`, at least one radius. @return whether it is complete
  bool advance(double milliseconds);
  bool complete() const { return next_ == directions * levels; }

  double height(int level) const;  // [m]
  /// [m], 0 where nothing is reached. @param direction from 0, in steps of 15 deg
  double radius(int level, int direction) const;
  /// Lines to draw [m] of what is found: sections across n3, and through it.
  std::vector<std::vector<Eigen::Vector3d>> paths() const;

 private:
  double search(double height, double direction) const;

  LaparoscopeReach reach_;
  LaparoscopeReach::Bounds bounds_;
  std::vector<double> radii_;  // [m], level by level
  int next_ = 0;               // radius to search for
};

}  // namespace trocar::gui
