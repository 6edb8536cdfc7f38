// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_limits.hpp"

namespace trocar {

/// Rubber at the ends of the device's ranges.
struct EndStopSettings {
  double stiffness = 1e5;            // [N/m], where the range is a length
  double damping = 150.0;            // [N s/m]
  double angular_stiffness = 300.0;  // [N m/rad], where it is an angle
  double angular_damping = 1.0;      // [N m s/rad]
};

/// One-sided spring-dampers on all ranges of LaparoscopeLimits. With the penetration
/// p > 0 and its gradient g = dp/dq:
///
///   tau = -max(0, k p + b p') g
///
/// The damping is handed out as a matrix, so that it can be integrated implicitly.
class EndStops {
 public:
  struct Reaction {
    Vector6d effort = Vector6d::Zero();   // of the springs [N, N m]
    Matrix6d damping = Matrix6d::Zero();  // sum of b g g^T over stops that press
    double potential = 0.0;               // [J]
    bool any = false;
  };

  /// @throw std::invalid_argument when a setting or a limit is out of its range.
  EndStops(const EndStopSettings& settings, const LaparoscopeLimits& limits,
           const LaparoscopeGeometry& geometry);

  Reaction reaction(const LaparoscopeConfiguration& configuration, const LaparoscopeRates& rates,
                    const Vector6d& velocity) const RT_SAFE;

 private:
  EndStopSettings settings_;
  LaparoscopeLimits limits_;
  double least_link_height_;  // [m]
};

}  // namespace trocar
