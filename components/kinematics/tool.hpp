// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/assembly_status.hpp"
#include "components/kinematics/matrices.hpp"
#include "components/kinematics/tool_roll.hpp"

namespace trocar {

/// The pose as the paper writes it. alpha and beta are the angles of the tool's
/// projections onto the n1n3 and n2n3 planes, neither Euler nor gimbal angles.
struct PoseCoordinates {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();  // E [m]
  double alpha = 0.0;                             // [rad], |alpha| < pi/2
  double beta = 0.0;                              // [rad], |beta| < pi/2
  double theta = 0.0;                             // [rad], ring angle, unwrapped
};

/// Rod AE that hangs at A on the delta's ball joint and slides through the gimbal at B:
///
///   d = B - A,  M = |d|,  t = d/M,  E = A + l t
///   omega = t x t' + kappa t        (kappa: tool_roll.hpp)
///
/// Defined while d3 > 0: A strictly behind the ring plane, tilt below 90 deg.
class Tool {
 public:
  struct State {
    Eigen::Vector3d ball;      // A [m]
    Eigen::Vector3d gimbal;    // B [m]
    Eigen::Vector3d tip;       // E [m]
    Eigen::Vector3d axis;      // t, unit
    double engagement = 0.0;   // M [m]
    double theta = 0.0;        // [rad], unwrapped
    RingDirection ring;        // (cos theta, sin theta)
    Eigen::Matrix3d rotation;  // R, N <- tool

    PoseCoordinates pose() const RT_SAFE;
    /// (xd, yd, zd, xt, yt, theta), with A = (xd, yd, -zd) [m, m, m, m, m, rad].
    Vector6d coordinates() const RT_SAFE;
    double tilt() const RT_SAFE;  // angle between t and n3 [rad]
  };

  /// First derivatives, for d' = vB - vA.
  struct Rates {
    Eigen::Matrix3d axis;   // t'    = axis d'                  [1/m]
    Eigen::Matrix3d swing;  // omega = swing d' + roll theta'   [1/m]
    Eigen::Vector3d roll;
  };

  /// Accelerations that are left when the actuators' are zero.
  struct Drift {
    Eigen::Vector3d axis;     // t'' [1/s^2]
    Eigen::Vector3d angular;  // omega' [rad/s^2]
  };

  Tool(double length, double ring_plane, RollModel roll)
      : l_(length), zt_(ring_plane), roll_(roll) {}

  /// @param centre (xt, yt) [m], @param ring (cos theta, sin theta)
  AssemblyStatus forward(const Eigen::Vector3d& ball, const Eigen::Vector2d& centre, double theta,
                         const RingDirection& ring, State& state) const RT_SAFE;

  /// Fills all of `state`. Regular also where the tip lies in the ring plane.
  AssemblyStatus inverse(const PoseCoordinates& pose, State& state) const RT_SAFE;

  /// The same from an orientation; theta is the turn nearest to `theta_near` [rad].
  AssemblyStatus inverse(const Eigen::Vector3d& tip, const Eigen::Matrix3d& rotation,
                         double theta_near, State& state) const RT_SAFE;

  Rates rates(const State& state) const RT_SAFE;

  /// @param span_rate d' [m/s], @param span_drift d'' [m/s^2] and @param ring_drift theta''
  /// [rad/s^2]: what is left of both when the actuators do not accelerate.
  Drift drift(const State& state, const Eigen::Vector3d& span_rate, double ring_rate,
              const Eigen::Vector3d& span_drift, double ring_drift) const RT_SAFE;

  /// JR: (vE; omega) = JR (xd', yd', zd', xt', yt', theta').
  Matrix6d jacobian(const State& state) const RT_SAFE;

  /// JP: rates of (xe, ye, ze, alpha, beta, theta). Not for forces: what is conjugate to
  /// alpha, beta, theta is no moment.
  Matrix6d pose_rate_jacobian(const State& state) const RT_SAFE;

  double length() const RT_SAFE { return l_; }
  double ring_plane() const RT_SAFE { return zt_; }

 private:
  AssemblyStatus from_slopes(const Eigen::Vector3d& tip, double slope_x, double slope_y,
                             double theta, State& state) const RT_SAFE;

  double l_;   // [m]
  double zt_;  // [m]
  RollModel roll_;
};

}  // namespace trocar
