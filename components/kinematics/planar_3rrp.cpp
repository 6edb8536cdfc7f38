// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/planar_3rrp.hpp"

#include <cmath>

#include "components/kinematics/three_phases.hpp"

namespace trocar {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

AssemblyStatus Planar3Rrp::forward(const Vector3d& rings, State& s) const RT_SAFE {
  if (!rings.allFinite()) return AssemblyStatus::not_finite;
  Vector3d sin_psi, cos_psi;
  for (int i = 0; i < 3; ++i) {
    const double psi = rings[i] - phase_angle[i];
    sin_psi[i] = std::sin(psi);
    cos_psi[i] = std::cos(psi);
    s.pins.col(i) = r_ * Vector2d(cos_psi[i] * phase_cos[i] - sin_psi[i] * phase_sin[i],
                                  sin_psi[i] * phase_cos[i] + cos_psi[i] * phase_sin[i]);
  }
  const Vector2d sum(cos_psi.sum(), sin_psi.sum());
  const double length = sum.norm();
  if (!(length > 1e-9)) return AssemblyStatus::rings_other_branch;
  s.heading = sum / length;
  s.sin_eps = sin_psi * s.heading.x() - cos_psi * s.heading.y();
  s.cos_eps = cos_psi * s.heading.x() + sin_psi * s.heading.y();
  // Against ring 1 and not against an earlier sample: theta then counts turns without a memory.
  s.theta = rings[0] - std::atan2(s.sin_eps[0], s.cos_eps[0]);
  for (int i = 0; i < 3; ++i) {
    s.along.col(i) << s.heading.x() * phase_cos[i] - s.heading.y() * phase_sin[i],
        s.heading.y() * phase_cos[i] + s.heading.x() * phase_sin[i];
    s.across.col(i) << -s.along(1, i), s.along(0, i);
  }
  s.centre = (2.0 * r_ / 3.0) * (s.across * s.sin_eps);
  s.rho = r_ * s.cos_eps - s.along.transpose() * s.centre;
  if (!(s.cos_eps.minCoeff() > 0.0)) return AssemblyStatus::rings_other_branch;
  if (!(s.centre.norm() < r_)) return AssemblyStatus::ring_pins_cannot_reach;
  return AssemblyStatus::ok;
}

AssemblyStatus Planar3Rrp::inverse(const Vector2d& centre, double theta,
                                   Vector3d& rings) const RT_SAFE {
  if (!centre.allFinite() || !std::isfinite(theta)) return AssemblyStatus::not_finite;
  if (!(centre.norm() < r_)) return AssemblyStatus::ring_pins_cannot_reach;
  const double c = std::cos(theta), s = std::sin(theta);
  for (int i = 0; i < 3; ++i) {
    const Vector2d across(-s * phase_cos[i] - c * phase_sin[i],
                          c * phase_cos[i] - s * phase_sin[i]);
    rings[i] = theta + phase_angle[i] + std::asin(across.dot(centre) / r_);
  }
  return AssemblyStatus::ok;
}

// sum n_i = 0 and sum n_i n_i^T = 3/2 I decouple theta' from c'.
Vector3d Planar3Rrp::solve(const State& s, const Vector3d& right) const RT_SAFE {
  const double theta_rate = right.sum() / s.rho.sum();
  const Vector2d c = (2.0 / 3.0) * (s.across * (right - theta_rate * s.rho));
  return {c.x(), c.y(), theta_rate};
}

Matrix3d Planar3Rrp::jacobian(const State& s) const RT_SAFE {
  const Eigen::RowVector3d arm = r_ * s.cos_eps.transpose();
  Matrix3d j;
  j.row(2) = arm / s.rho.sum();
  const Vector2d rho_across = s.across * s.rho;
  j.topRows<2>() = (2.0 / 3.0) * (s.across * arm.asDiagonal() - rho_across * j.row(2));
  return j;
}

Vector3d Planar3Rrp::drift(const State& s, const Vector3d& ring_rates,
                           const Vector3d& star_rates) const RT_SAFE {
  const double theta_rate = star_rates[2];
  const Vector3d sliding = s.along.transpose() * star_rates.head<2>();
  const Vector3d right =
      (r_ * s.sin_eps.array() * ring_rates.array() * (2.0 * theta_rate - ring_rates.array()) +
       2.0 * theta_rate * sliding.array())
          .matrix();
  return solve(s, right);
}

}  // namespace trocar
