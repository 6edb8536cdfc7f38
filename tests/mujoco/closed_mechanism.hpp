// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "components/kinematics/matrices.hpp"
#include "tests/mujoco/mechanism.hpp"

namespace trocar::test {

/// MuJoCo's open tree with its loops closed exactly, in the actuators' coordinates
/// q = (q1, q2, q3, phi1, phi2, phi3).
///
/// From MuJoCo come the places of bodies, the Jacobians of sites, the tree's mass matrix M, its
/// bias b and the accelerations of sites. With r the distances that must be 0 and J = dr/dv, the
/// tree's velocities v follow the actuators by
///
///   J S = 0, S = 1 in the actuators' rows:   v = S q',  v' = S q'' + a,  J a = -J' v
///
/// and virtual work leaves
///
///   S^T M S q'' + S^T (b + M a) = tau + S^T Jtip^T F
///
/// J' v is the sites' relative acceleration with v' = 0: nothing is differenced. MuJoCo's own
/// equality constraints are springs and are not used.
class ClosedMechanism {
 public:
  struct Bias {
    Vector6d effort;          // without gravity [N, N m]
    Vector6d twist;           // of the tool at its tip
    Eigen::Vector3d tip;      // acceleration of the tip when q'' = 0 [m/s^2]
    Eigen::Vector3d angular;  // of the tool when q'' = 0 [rad/s^2]
  };

  /// @throw std::runtime_error with MuJoCo's words
  explicit ClosedMechanism(const Mechanism& mechanism);

  /// Follows the loops from the reference to q, by Newton to round-off; what is asked next is
  /// asked of that place. @return largest distance left in a loop [m, rad]
  double assemble(const Vector6d& q);

  Eigen::Vector3d place(const char* site) const;
  Eigen::Matrix3d tool_rotation() const;
  Matrix6d jacobian() const;  // (vE; omega) from q'
  Matrix6d mass() const;

  /// @param gravity [m/s^2]
  Vector6d holding_effort(const Eigen::Vector3d& gravity);

  Bias bias(const Vector6d& velocity);

 private:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  struct Loop {
    int one, other, axes;  // sites
  };

  Matrix site_jacobian(int site) const;        // 6 x nv: linear, angular
  Vector6d site_acceleration(int site) const;  // linear, angular
  Matrix loop_jacobian() const;
  Eigen::VectorXd loop_distances() const;
  Eigen::VectorXd loop_drift() const;
  Eigen::VectorXd solve_dependent(const Matrix& jacobian, const Eigen::VectorXd& right) const;
  void tree_velocity(const Eigen::VectorXd& v);
  double newton(double enough);
  int id(mjtObj kind, const std::string& name) const;

  std::unique_ptr<mjModel, void (*)(mjModel*)> model_;
  std::unique_ptr<mjData, void (*)(mjData*)> data_;
  std::vector<Loop> loops_;
  std::vector<int> equal_hinges_;   // degrees of freedom, none or two
  std::array<int, 6> actuators_{};  // degrees of freedom
  std::array<int, 6> positions_{};  // of the same in qpos
  std::vector<int> dependent_;      // all other degrees of freedom
  Eigen::Index equations_ = 0;
  Eigen::MatrixXd s_;  // S
};

}  // namespace trocar::test
