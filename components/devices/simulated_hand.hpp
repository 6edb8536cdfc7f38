// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/tool.hpp"

namespace trocar {

enum class HandMode { absent, relaxed, firm, pushes };

/// How a pushing hand moves its own target: along a path that bows sideways as a parabola,
///   x_h = x_0 + u depth direction + 4 u (1 - u) bow,     u = (1 - cos(pi s / rise)) / 2,
/// and back, staying for `dwell` at either end, over and over.
struct PushSettings {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit, in N
  Eigen::Vector3d bow = Eigen::Vector3d::Zero();         // half way, off the straight line [m]
  double depth = 0.040;                                  // [m], >= 0
  double start = 0.2;                                    // [s], >= 0
  double rise = 1.0;                                     // [s], > 0
  double dwell = 1.0;                                    // [s], >= 0; infinity: never back
};

/// The figures are those of a firm hand. How much of its stiffness and damping a relaxed one has is
/// an assumption.
struct HandSettings {
  HandMode mode = HandMode::firm;
  double relaxed_grip = 0.3;          // share of stiffness and damping, 0 to 1
  double mass = 0.3;                  // m_h [kg]
  double damping = 8.0;               // b_h [N s/m]
  double stiffness = 250.0;           // k_h [N/m]
  double rotational_damping = 0.02;   // [N m s/rad]
  double rotational_stiffness = 1.0;  // [N m/rad]
  PushSettings push = {};
};

/// A hand that grasps the tool at E:
///
///   f = -m_h a - b_h (v - v_h) - k_h (x - x_h)
///   m = -b_r omega + k_r log(R_h R^T)
///
/// A relaxed or firm hand holds the pose that it grasped, one that pushes moves its target x_h.
/// Here stand the springs and the target (x_h, v_h, R_h); who integrates the motion treats
/// mass and damping implicitly.
class SimulatedHand {
 public:
  /// @throw std::invalid_argument when a setting is out of its range.
  explicit SimulatedHand(const HandSettings& settings);

  /// The pose that the hand holds from now on, or from which it pushes.
  void grasp(const Tool::State& tool) RT_SAFE;

  /// Springs alone: (force; moment about E) on the tool. @param time [s] since the start
  Vector6d spring_wrench(const Tool::State& tool, double time) const RT_SAFE;
  Eigen::Vector3d target(double time) const RT_SAFE;                     // x_h [m]
  Eigen::Vector3d target_velocity(double time) const RT_SAFE;            // v_h [m/s]
  double potential(const Tool::State& tool, double time) const RT_SAFE;  // of the springs [J]

  bool present() const RT_SAFE { return settings_.mode != HandMode::absent; }
  /// As they act: a relaxed hand's are reduced already.
  const HandSettings& settings() const RT_SAFE { return settings_; }

 private:
  HandSettings settings_;
  Eigen::Vector3d rest_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rest_rotation_ = Eigen::Matrix3d::Identity();
};

/// log(R) as a vector along the axis of R, its length the angle in [0, pi) [rad].
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation) RT_SAFE;

}  // namespace trocar
