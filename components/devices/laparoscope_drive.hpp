// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "components/devices/dry_friction.hpp"
#include "components/devices/laparoscope_drive_settings.hpp"
#include "components/devices/position_wave.hpp"

namespace trocar {

/// Motors, amplifiers and encoders of the six actuators, drawn once from a seed. With w a wave of
/// amplitude 1 along the way, of its own pitch and phase:
///
///   effort = gain_i (1 + ripple w_i(q_i)) sent_i + cogging_i w'_i(q_i)
///   sent   = saturate(quantise(command)),   read = round((q + home) / res) res
class LaparoscopeDrive {
 public:
  /// @throw std::invalid_argument when a setting is out of its range.
  LaparoscopeDrive(const LaparoscopeDriveSettings& settings, const Imperfections& imperfections,
                   std::uint64_t seed);

  /// What the amplifiers make of a command; NaN gives 0 [N, N m].
  Vector6d sent(const Vector6d& command) const RT_SAFE;

  /// What the mechanism gets of it at the position q [N, N m].
  Vector6d effort(const Vector6d& sent, const Vector6d& q) const RT_SAFE;

  /// What the encoders tell of the position q [m, rad].
  Vector6d read(const Vector6d& q) const RT_SAFE;

  const Vector6d& viscous() const RT_SAFE { return viscous_; }
  /// The most that dry friction gives at a velocity [N, N m].
  Vector6d dry_friction(const Vector6d& velocity) const RT_SAFE {
    return dry_friction_.limit(velocity);
  }
  const Vector6d& gain() const RT_SAFE { return gain_; }
  const Vector6d& homing_error() const RT_SAFE { return homing_; }

 private:
  /// What differs from device to device.
  struct Draw {
    Vector6d gain, ripple_phase, cogging_phase, homing;
  };
  static Draw draw(const LaparoscopeDriveSettings& settings, std::uint64_t seed);
  LaparoscopeDrive(const LaparoscopeDriveSettings& settings, const Imperfections& imperfections,
                   const Draw& drawn);

  Imperfections imperfections_;
  double ripple_;
  Vector6d peak_, dac_step_, viscous_, gain_, cogging_, resolution_, homing_;
  DryFriction dry_friction_;
  PositionWave ripple_wave_, cogging_wave_;
};

}  // namespace trocar
