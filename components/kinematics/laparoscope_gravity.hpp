// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_model.hpp"

namespace trocar {

/// g in N of a device that stands upright [m/s^2].
inline const Eigen::Vector3d standard_gravity{0.0, 0.0, -9.80665};

/// Weight of the moving parts; the rings themselves are balanced.
///
///   V = -g·sum m r,   tau_g = dV/dq        (the effort that holds the device)
///
/// Exact for uniform link rods, whose mass counts half at each end.
class LaparoscopeGravity {
 public:
  /// @throw std::invalid_argument when a mass is negative or not finite.
  LaparoscopeGravity(const LaparoscopeGeometry& geometry, const LaparoscopeMasses& masses);

  /// tau_g [N, N m]. @param gravity g in N [m/s^2], turned with the mount
  Vector6d effort(const LaparoscopeConfiguration& configuration, const LaparoscopeRates& rates,
                  const Eigen::Vector3d& gravity) const RT_SAFE;

  /// V [J].
  double potential(const LaparoscopeConfiguration& configuration,
                   const Eigen::Vector3d& gravity) const RT_SAFE;

 private:
  LaparoscopeMasses m_;
  double ring_plane_;  // [m]
};

}  // namespace trocar
