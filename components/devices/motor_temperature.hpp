// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/laparoscope_drive_settings.hpp"
#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// How warm the six motors are, and what that does. With the effort u, of which u_c can be given
/// for ever, each winding's rise above the room is a first-order lag of the copper's losses, and
/// its magnets' a slower one of the winding's:
///
///   tau theta' = Theta (u / u_c)^2 - theta        tau_m theta_m' = share theta - theta_m   [K]
///
/// The limit that the amplifiers keep falls with it from peak to continuous,
///
///   limit = u_c + (u_p - u_c) clamp((Theta - theta) / (Theta - theta_s), 0, 1)
///
/// so that theta never exceeds Theta; and warm magnets lose gain, 1 - loss theta_m. The form is
/// that of a winding behind one thermal resistance; resistance that rises with it, iron and
/// friction heat nothing.
class MotorTemperature {
 public:
  /// @throw std::invalid_argument when a setting is out of its range.
  MotorTemperature(const LaparoscopeDriveSettings& settings, const Imperfections& imperfections);

  /// What `effort` [N, N m] does in a time [s]; exact for a winding.
  void advance(double duration, const Vector6d& effort) RT_SAFE;

  /// `effort`, or the most of it that may be given now [N, N m].
  Vector6d limited(const Vector6d& effort) const RT_SAFE;

  const Vector6d& rise() const RT_SAFE { return winding_; }        // theta [K]
  const Vector6d& magnet_rise() const RT_SAFE { return magnet_; }  // theta_m [K]
  const Vector6d& gain() const RT_SAFE { return gain_; }           // 1 - loss theta_m

  /// Starts as warm as this: rises of windings and magnets [K].
  void start(const Vector6d& winding, const Vector6d& magnet) RT_SAFE;

 private:
  void update() RT_SAFE;

  ThermalSettings settings_;
  bool derates_, drifts_;
  double steepness_;  // 1 / (Theta - theta_s) [1/K]
  Vector6d heating_;  // Theta / u_c^2 [K/N^2, K/(N m)^2]
  Vector6d continuous_, spare_;
  Vector6d winding_ = Vector6d::Zero();
  Vector6d magnet_ = Vector6d::Zero();
  Vector6d gain_ = Vector6d::Ones();
  Vector6d limit_;  // [N, N m]
};

}  // namespace trocar
