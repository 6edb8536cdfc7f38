// SPDX-License-Identifier: Apache-2.0
#include "components/devices/series_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace trocar {
namespace {

// Drift, kick, drift of a spring is stable up to omega h = 2.
constexpr double largest_phase = 1.25;

}  // namespace

SeriesCompliance::SeriesCompliance(const LaparoscopeDriveSettings& s, const Vector6d& axis_inertia)
    : inertia_(both(s.slider.motor_inertia, s.ring.motor_inertia)),
      stiffness_(both(s.slider.stiffness, s.ring.stiffness)) {
  const Vector6d beyond = axis_inertia - inertia_;
  for (int i = 0; i < 6; ++i) {
    if (beyond[i] > 0.0) continue;
    std::ostringstream text;
    text << "transmission: a motor's side of " << inertia_[i] << (i < 3 ? " kg" : " kg m^2")
         << " leaves nothing of the axis' " << axis_inertia[i] << "; lower "
         << (i < 3 ? "slider_motor_mass" : "ring_motor_inertia");
    throw std::invalid_argument(text.str());
  }
  const Vector6d reduced = inertia_.cwiseProduct(beyond).cwiseQuotient(axis_inertia);
  damping_ = 2.0 * s.transmission_damping * stiffness_.cwiseProduct(reduced).cwiseSqrt();
  longest_step_ = largest_phase * std::sqrt(reduced.cwiseQuotient(stiffness_).minCoeff());
}

void SeriesCompliance::rest(const Vector6d& q, const Vector6d& velocity,
                            const Vector6d& effort) RT_SAFE {
  position_ = q + effort.cwiseQuotient(stiffness_);
  velocity_ = velocity;
}

Vector6d SeriesCompliance::effort(const Vector6d& q, const Vector6d& velocity) const RT_SAFE {
  return stiffness_.cwiseProduct(position_ - q) + damping_.cwiseProduct(velocity_ - velocity);
}

void SeriesCompliance::kick(double h, const Vector6d& effort, const Vector6d& viscous,
                            const Vector6d& dry_friction) RT_SAFE {
  for (int i = 0; i < 6; ++i) {
    const double half = 0.5 * h * viscous[i];
    const double impulse = (inertia_[i] - half) * velocity_[i] + h * effort[i];
    const double moves = std::max(0.0, std::abs(impulse) - h * dry_friction[i]);
    velocity_[i] = moves > 0.0 ? std::copysign(moves, impulse) / (inertia_[i] + half) : 0.0;
  }
}

double SeriesCompliance::energy(const Vector6d& q) const RT_SAFE {
  const Vector6d stretch = position_ - q;
  return 0.5 * inertia_.dot(velocity_.cwiseProduct(velocity_)) +
         0.5 * stiffness_.dot(stretch.cwiseProduct(stretch));
}

}  // namespace trocar
