// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_gravity.hpp"
#include "components/kinematics/laparoscope_model.hpp"

namespace trocar {

/// Rigid-body dynamics in the actuators' coordinates:
///
///   M(q) q'' + c(q, q') + tau_g(q) = tau + J^T F_hand
///
/// The links are slender rods, their inertia exact. The accelerations that remain when
/// q'' = 0 are analytic; nothing is differenced.
class LaparoscopeDynamics {
 public:
  /// What depends on q alone.
  struct Inertia {
    Matrix6d mass;              // M
    Matrix36d centre_jacobian;  // Jc: velocity of the tool's centre of mass
  };

  /// What depends on q and q'.
  struct Bias {
    Vector6d effort;          // c [N, N m], gravity excluded
    Vector6d twist;           // (vE; omega)
    Eigen::Vector3d tip;      // E'' when q'' = 0 [m/s^2]
    Eigen::Vector3d angular;  // omega' when q'' = 0 [rad/s^2]
  };

  /// @throw std::invalid_argument when geometry or masses cannot be built.
  LaparoscopeDynamics(const LaparoscopeGeometry& geometry, const LaparoscopeMasses& masses);

  Inertia inertia(const LaparoscopeConfiguration& configuration,
                  const LaparoscopeRates& rates) const RT_SAFE;

  Bias bias(const LaparoscopeConfiguration& configuration, const LaparoscopeRates& rates,
            const Inertia& inertia, const Vector6d& velocity) const RT_SAFE;

  const LaparoscopeModel& model() const RT_SAFE { return model_; }
  const LaparoscopeGravity& gravity() const RT_SAFE { return gravity_; }
  const LaparoscopeMasses& masses() const RT_SAFE { return m_; }

 private:
  LaparoscopeModel model_;
  LaparoscopeGravity gravity_;
  LaparoscopeMasses m_;
};

}  // namespace trocar
