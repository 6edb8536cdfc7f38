// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/assembly_status.hpp"
#include "components/kinematics/matrices.hpp"

namespace trocar {

/// Planar mechanism of three concentric rings. Pin i of ring i slides along spoke i of a
/// star that is centred at c and turned by theta:
///
///   P_i = r (cos phi_i, sin phi_i) = c + rho_i d_i,   rho_i > 0
///   d_i = (cos(theta + D_i), sin(theta + D_i)),  n_i = d_i turned by +90 deg
///   eps_i = phi_i - D_i - theta,   n_i·c = r sin eps_i
///
/// theta is the circular mean of phi_i - D_i; it counts turns with the rings. No
/// singularity for |c| < r.
class Planar3Rrp {
 public:
  struct State {
    Eigen::Vector2d centre;   // c [m]
    double theta = 0.0;       // [rad], unwrapped
    Eigen::Vector2d heading;  // (cos theta, sin theta)
    Matrix23d pins;           // P_i [m]
    Matrix23d along;          // d_i
    Matrix23d across;         // n_i
    Eigen::Vector3d sin_eps;
    Eigen::Vector3d cos_eps;
    Eigen::Vector3d rho;  // [m]
  };

  explicit Planar3Rrp(double ring_radius) : r_(ring_radius) {}

  AssemblyStatus forward(const Eigen::Vector3d& rings, State& state) const RT_SAFE;
  AssemblyStatus inverse(const Eigen::Vector2d& centre, double theta,
                         Eigen::Vector3d& rings) const RT_SAFE;

  /// JT: (xt', yt', theta') = JT phi', from  n_i·c' + rho_i theta' = r cos eps_i phi_i'.
  Eigen::Matrix3d jacobian(const State& state) const RT_SAFE;

  /// (xt'', yt'', theta'') when phi'' = 0, given the rates of rings and of (xt, yt, theta).
  Eigen::Vector3d drift(const State& state, const Eigen::Vector3d& ring_rates,
                        const Eigen::Vector3d& star_rates) const RT_SAFE;

 private:
  /// (c'; theta') with n_i·c' + rho_i theta' = right_i.
  Eigen::Vector3d solve(const State& state, const Eigen::Vector3d& right) const RT_SAFE;

  double r_;  // [m]
};

}  // namespace trocar
