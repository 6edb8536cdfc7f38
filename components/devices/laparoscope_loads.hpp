// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_model.hpp"

namespace trocar {

/// What an effort of the actuators does to the hand and to the two stages that carry the tool, by
/// the driver's own kinematics:
///
///   (f; m) = J^-T tau at E,   at the handle X:  m_X = m - (X - E) x f
///   gimbal stage, at B:  f_B = (1/M) (m + l t x f) x t        delta stage, at A:  f_A = f - f_B
///
/// A lateral force f at E so loads the gimbal's stage with f l/M and the delta's with f (l/M - 1).
class LaparoscopeLoads {
 public:
  struct Loads {
    Eigen::Vector3d handle_force;   // [N] on the hand
    Eigen::Vector3d handle_moment;  // [N m] on the hand, about the handle
    Eigen::Vector3d delta;          // f_A [N]
    Eigen::Vector3d gimbal;         // f_B [N]
  };

  /// @param handle_offset s of the handle X = E + s t [m]
  /// @throw std::invalid_argument when the geometry cannot be built.
  LaparoscopeLoads(const LaparoscopeGeometry& geometry, double handle_offset)
      : model_(geometry), handle_offset_(handle_offset) {}

  /// Moves to where the actuators are; when that cannot be assembled it stays where it was.
  AssemblyStatus update(const Vector6d& position) RT_SAFE;

  Loads of(const Vector6d& effort) const RT_SAFE;
  /// [m/s] of the handle.
  double handle_speed(const Vector6d& velocity) const RT_SAFE;

 private:
  LaparoscopeModel model_;
  double handle_offset_;
  Tool::State tool_;
  Matrix6d jacobian_ = Matrix6d::Zero();
  Matrix6d wrench_from_effort_ = Matrix6d::Zero();  // J^-T
};

}  // namespace trocar
