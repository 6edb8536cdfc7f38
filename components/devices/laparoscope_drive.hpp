// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "components/kinematics/matrices.hpp"
#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// What keeps a real device from being its model; each can be switched off.
struct Imperfections {
  bool viscous_friction = true;
  bool coulomb_friction = true;
  bool gain_error = true;             // torque constants, warm magnets, capstan loss
  bool force_ripple = true;           // cogging, periodic in the position
  bool effort_quantisation = true;    // DAC
  bool saturation = true;             // at the peak effort
  bool position_quantisation = true;  // encoders
  bool homing_error = true;

  static constexpr Imperfections none() {
    return {false, false, false, false, false, false, false, false};
  }
};

/// Figures of one kind of actuator. Units: N, m for sliders; N m, rad for rings.
struct ActuatorSettings {
  double peak = 0.0;          // [N, N m]
  double viscous = 0.0;       // [N s/m, N m s/rad]
  double coulomb = 0.0;       // [N, N m]
  double ripple_pitch = 1.0;  // [m, rad]
  double resolution = 0.0;    // of the encoder [m, rad]
  double homing_low = 0.0;    // magnitude of the homing error [m, rad]
  double homing_high = 0.0;
};

struct LaparoscopeDriveSettings {
  ActuatorSettings slider{.peak = 200.0,
                          .viscous = 8.0,
                          .coulomb = 0.35,
                          .ripple_pitch = 25.6e-3,
                          .resolution = 2e-6,
                          .homing_low = 0.1e-3,
                          .homing_high = 0.2e-3};
  ActuatorSettings ring{.peak = 12.0,
                        .viscous = 0.06,
                        .coulomb = 0.013,
                        .ripple_pitch = 32e-3,
                        .resolution = 0.00010226538585904274,  // 2 pi / (4*1024*15)
                        .homing_low = 0.0,
                        .homing_high = 1e-3};
  int dac_bits = 14;           // over +-peak
  double gain = 0.9655;        // mean of the six, unless gain_error is off
  double gain_spread = 0.004;  // each lies within gain +- this
  double ripple = 0.007;       // amplitude relative to the effort
};

/// Motors, amplifiers and encoders of the six actuators, drawn once from a seed.
///
///   effort = gain_i (1 + ripple sin(2 pi q_i / pitch_i + phase_i)) sent_i
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
  const Vector6d& coulomb() const RT_SAFE { return coulomb_; }
  const Vector6d& gain() const RT_SAFE { return gain_; }
  const Vector6d& homing_error() const RT_SAFE { return homing_; }

 private:
  Imperfections imperfections_;
  double ripple_;
  Vector6d peak_, dac_step_, viscous_, coulomb_, gain_, wave_number_, phase_, resolution_, homing_;
};

}  // namespace trocar
