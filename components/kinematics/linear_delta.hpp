// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/assembly_status.hpp"
#include "components/kinematics/matrices.hpp"

namespace trocar {

/// Delta with three rails parallel to n3; its platform only translates.
///
///   |A - C_i| = L,   C_i = (e cos D_i, e sin D_i, q_i),   D = (0, 120, 240) deg
///
/// e = base minus platform radius. Of the assembly modes the one with the platform
/// on the +n3 side of every slider is taken.
class LinearDelta {
 public:
  struct State {
    Eigen::Vector3d platform;  // A [m]
    Eigen::Matrix3d links;     // row i: A - C_i [m]
  };

  struct Rates {
    Eigen::Matrix3d jacobian;       // vA = jacobian q'
    Eigen::Matrix3d inverse_links;  // [1/m]
  };

  LinearDelta(double base_radius, double platform_radius, double link_length);

  AssemblyStatus forward(const Eigen::Vector3d& sliders, State& state) const RT_SAFE;
  AssemblyStatus inverse(const Eigen::Vector3d& platform, Eigen::Vector3d& sliders) const RT_SAFE;
  Rates rates(const State& state) const RT_SAFE;

  /// A'' when q'' = 0 [m/s^2], from  l_i·A'' = l_i3 q_i'' - |vA - q_i' n3|^2.
  Eigen::Vector3d drift(const Rates& rates, const Eigen::Vector3d& slider_rates,
                        const Eigen::Vector3d& platform_velocity) const RT_SAFE;

 private:
  double e_;  // [m]
  double L_;  // [m]
};

}  // namespace trocar
