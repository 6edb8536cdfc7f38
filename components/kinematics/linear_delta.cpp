// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/linear_delta.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "components/kinematics/three_phases.hpp"

namespace trocar {

using Eigen::Matrix3d;
using Eigen::Vector3d;

LinearDelta::LinearDelta(double base_radius, double platform_radius, double link_length)
    : e_(base_radius - platform_radius), L_(link_length) {}

// Subtracting the mean of the three spheres leaves A on a line (a0 + a1 w, b0 + b1 w, mean + w).
AssemblyStatus LinearDelta::forward(const Vector3d& q, State& state) const RT_SAFE {
  if (!q.allFinite()) return AssemblyStatus::not_finite;
  const double mean = (q[0] + q[1] + q[2]) / 3.0;
  double a0 = 0.0, a1 = 0.0, b0 = 0.0, b1 = 0.0, square = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double d = q[i] - mean;
    a0 += d * d * phase_cos[i];
    b0 += d * d * phase_sin[i];
    a1 += d * phase_cos[i];
    b1 += d * phase_sin[i];
    square += d * d;
  }
  const double scale = 1.0 / (3.0 * e_);
  a0 *= scale;
  b0 *= scale;
  a1 *= -2.0 * scale;
  b1 *= -2.0 * scale;

  const double a = 1.0 + a1 * a1 + b1 * b1;
  const double b = a0 * a1 + b0 * b1;
  const double c = a0 * a0 + b0 * b0 + e_ * e_ + square / 3.0 - L_ * L_;
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0.0)) return AssemblyStatus::delta_links_cannot_reach;
  const double root = std::sqrt(discriminant);
  const double w = b <= 0.0 ? (root - b) / a : -c / (b + root);  // larger root, no cancellation

  state.platform = {a0 + a1 * w, b0 + b1 * w, mean + w};
  for (int i = 0; i < 3; ++i)
    state.links.row(i) =
        state.platform.transpose() - Eigen::RowVector3d(e_ * phase_cos[i], e_ * phase_sin[i], q[i]);
  if (!(state.links.col(2).minCoeff() > 0.0)) return AssemblyStatus::delta_other_branch;
  return AssemblyStatus::ok;
}

AssemblyStatus LinearDelta::inverse(const Vector3d& platform, Vector3d& sliders) const RT_SAFE {
  if (!platform.allFinite()) return AssemblyStatus::not_finite;
  for (int i = 0; i < 3; ++i) {
    const double x = platform.x() - e_ * phase_cos[i];
    const double y = platform.y() - e_ * phase_sin[i];
    const double radicand = L_ * L_ - x * x - y * y;
    if (!(radicand > 0.0)) return AssemblyStatus::delta_links_cannot_reach;
    sliders[i] = platform.z() - std::sqrt(radicand);
  }
  return AssemblyStatus::ok;
}

LinearDelta::Rates LinearDelta::rates(const State& state) const RT_SAFE {
  const Vector3d l0 = state.links.row(0), l1 = state.links.row(1), l2 = state.links.row(2);
  const Vector3d c0 = l1.cross(l2);
  const double scale = 1.0 / l0.dot(c0);
  Rates rates;
  rates.inverse_links.col(0) = scale * c0;
  rates.inverse_links.col(1) = scale * l2.cross(l0);
  rates.inverse_links.col(2) = scale * l0.cross(l1);
  rates.jacobian = rates.inverse_links * state.links.col(2).asDiagonal();
  return rates;
}

Vector3d LinearDelta::drift(const Rates& rates, const Vector3d& slider_rates,
                            const Vector3d& platform_velocity) const RT_SAFE {
  const double lateral = platform_velocity.head<2>().squaredNorm();
  const Vector3d closing = platform_velocity.z() - slider_rates.array();
  return -rates.inverse_links * (closing.array().square() + lateral).matrix();
}

}  // namespace trocar
