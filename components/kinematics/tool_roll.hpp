// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "framework/abi.hpp"
#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// How the ring's angle theta is passed on to the tool's roll about its axis t.
enum class RollModel {
  gimbal_outer_y,  // R = Rz(theta) Ry(g1) Rx(g2): Hooke joint, outer axis y of the ring
  gimbal_outer_x,  // R = Rz(theta) Rx(g1) Ry(g2): Hooke joint, outer axis x of the ring
  zero_torsion,    // R = Rmin(n3 -> t) Rz(theta): constant-velocity joint
};

/// The ring's angle as the unit vector (cos theta, sin theta).
using RingDirection = Eigen::Vector2d;

/// Orientation of the tool in N; its third column is t.
/// @param axis t, unit, t3 > 0 (tilt below 90 deg)
Eigen::Matrix3d tool_rotation(RollModel model, const Eigen::Vector3d& axis,
                              const RingDirection& ring) RT_SAFE;

/// theta in (-pi, pi] of a tool orientation with R33 > 0 [rad].
double ring_angle(RollModel model, const Eigen::Matrix3d& rotation) RT_SAFE;

/// Spin of the tool about its own axis, with which omega = t x t' + kappa t:
///
///   kappa = gain theta' + lever·(t x t')                  [rad/s]
///   gimbal with outer axis o, u = o·t:  gain = t3/(1-u^2), lever = u o/(1-u^2)
///   zero torsion:                       gain = 1,          lever = -n3/(1+t3)
struct RollRate {
  double gain = 1.0;
  Eigen::Vector3d lever = Eigen::Vector3d::Zero();
};

RollRate roll_rate(RollModel model, const Eigen::Vector3d& axis, const RingDirection& ring) RT_SAFE;

/// Time derivative of both fields of roll_rate() while t moves with t' and the ring with theta'.
RollRate roll_rate_derivative(RollModel model, const Eigen::Vector3d& axis,
                              const RingDirection& ring, const Eigen::Vector3d& axis_rate,
                              double ring_rate) RT_SAFE;

}  // namespace trocar
