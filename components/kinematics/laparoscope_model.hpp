// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/assembly_status.hpp"
#include "components/kinematics/laparoscope_geometry.hpp"
#include "components/kinematics/linear_delta.hpp"
#include "components/kinematics/matrices.hpp"
#include "components/kinematics/planar_3rrp.hpp"
#include "components/kinematics/tool.hpp"

namespace trocar {

/// The whole mechanism at one position of its actuators
/// q = (q1, q2, q3, phi1, phi2, phi3) [m, m, m, rad, rad, rad].
struct LaparoscopeConfiguration {
  Vector6d q = Vector6d::Zero();
  LinearDelta::State delta;
  Planar3Rrp::State rings;
  Tool::State tool;
};

/// First derivatives with respect to q, evaluated once and shared by all that needs them.
struct LaparoscopeRates {
  LinearDelta::Rates delta;
  Eigen::Matrix3d rings;  // JT: (xt', yt', theta') from phi'
  Tool::Rates tool;
  Matrix6d jacobian;  // J: (vE; omega) = J q', both in N
};

/// Kinematics and statics of the laparoscopic interface: a linear delta carries the
/// tool's end A, three rings (3RRP) carry the gimbal at B, the tool slides through it.
///
///   (vE; omega) = J q',   tau = J^T F
///
/// F = (force; moment about E) that the device exerts on the hand, in N.
/// tau: N at the sliders, N m at the rings (motor torque = tau / capstan ratio).
class LaparoscopeModel {
 public:
  /// @throw std::invalid_argument when the geometry cannot be built.
  explicit LaparoscopeModel(const LaparoscopeGeometry& geometry = {});

  /// Unless the status is ok, parts of `configuration` hold no meaning.
  AssemblyStatus forward(const Vector6d& q, LaparoscopeConfiguration& configuration) const RT_SAFE;

  AssemblyStatus inverse(const PoseCoordinates& pose, Vector6d& q) const RT_SAFE;

  /// @param theta_near of the ring angles that differ by whole turns the nearest to this is
  /// taken [rad]
  AssemblyStatus inverse(const Eigen::Vector3d& tip, const Eigen::Matrix3d& rotation,
                         double theta_near, Vector6d& q) const RT_SAFE;

  LaparoscopeRates rates(const LaparoscopeConfiguration& configuration) const RT_SAFE;

  const LaparoscopeGeometry& geometry() const RT_SAFE { return geometry_; }
  const LinearDelta& delta() const RT_SAFE { return delta_; }
  const Planar3Rrp& rings() const RT_SAFE { return rings_; }
  const Tool& tool() const RT_SAFE { return tool_; }

 private:
  AssemblyStatus actuators(const Tool::State& tool, Vector6d& q) const RT_SAFE;

  LaparoscopeGeometry geometry_;
  LinearDelta delta_;
  Planar3Rrp rings_;
  Tool tool_;
};

/// tau = J^T F.
Vector6d static_effort(const LaparoscopeRates& rates, const Vector6d& wrench) RT_SAFE;

/// The point E + s t of the tool [m]. @param s [m], negative towards A
Eigen::Vector3d point_on_tool(const Tool::State& tool, double s) RT_SAFE;

/// A wrench with its moment about X becomes the same wrench with its moment about E:
/// (f; m + (X - E) x f).
Vector6d wrench_at_tip(const Tool::State& tool, const Eigen::Vector3d& point,
                       const Vector6d& wrench) RT_SAFE;

/// Velocity of a point X that moves with the tool [m/s]. @param twist (vE; omega)
Eigen::Vector3d velocity_at(const Tool::State& tool, const Eigen::Vector3d& point,
                            const Vector6d& twist) RT_SAFE;

}  // namespace trocar
