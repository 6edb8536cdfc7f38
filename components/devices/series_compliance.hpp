// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/laparoscope_drive_settings.hpp"
#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// Six motors, with encoders, friction and a part of each axis' inertia, on the springs of their
/// transmissions (cables, belts, bearings):
///
///   J theta'' = tau - friction - s,      s = k (theta - q) + d (theta' - q')
///
/// q is the mechanism's, which s drives. d is a share of 2 sqrt(k m) with m = J m_q / (J + m_q)
/// for an axis by itself, m_q its inertia beyond the spring.
class SeriesCompliance {
 public:
  /// @param axis_inertia of slider or ring as a whole [kg, kg m^2]
  /// @throw std::invalid_argument when the motors would have all of it or more.
  SeriesCompliance(const LaparoscopeDriveSettings& settings, const Vector6d& axis_inertia);

  /// At rest relative to the mechanism, the springs loaded by `effort` [N, N m].
  void rest(const Vector6d& q, const Vector6d& velocity, const Vector6d& effort) RT_SAFE;

  void drift(double h) RT_SAFE { position_ += h * velocity_; }

  /// s on the mechanism at q, q' [N, N m].
  Vector6d effort(const Vector6d& q, const Vector6d& velocity) const RT_SAFE;

  /// One kick: viscous friction by the trapezoidal rule, dry friction sticks exactly.
  /// @param effort on the motors, the springs' included [N, N m]
  void kick(double h, const Vector6d& effort, const Vector6d& viscous,
            const Vector6d& dry_friction) RT_SAFE;

  const Vector6d& position() const RT_SAFE { return position_; }  // theta [m, rad]
  const Vector6d& velocity() const RT_SAFE { return velocity_; }  // [m/s, rad/s]
  const Vector6d& inertia() const RT_SAFE { return inertia_; }    // J [kg, kg m^2]
  const Vector6d& stiffness() const RT_SAFE { return stiffness_; }

  /// Of motion and springs [J].
  double energy(const Vector6d& q) const RT_SAFE;

  /// With which the explicit integration of the springs is still far from its limit [s].
  double longest_step() const { return longest_step_; }

 private:
  Vector6d inertia_, stiffness_, damping_;
  double longest_step_;
  Vector6d position_ = Vector6d::Zero();
  Vector6d velocity_ = Vector6d::Zero();
};

}  // namespace trocar
