// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/matrices.hpp"

namespace trocar {

/// What keeps a real device from being its model; each can be switched off.
struct Imperfections {
  bool viscous_friction = true;
  bool coulomb_friction = true;
  bool stribeck = true;               // dry friction is higher near rest
  bool gain_error = true;             // torque constants, capstan loss
  bool gain_drift = true;             // warm magnets
  bool force_ripple = true;           // of the effort, periodic in the position
  bool cogging = true;                // without any effort, periodic in the position
  bool effort_quantisation = true;    // DAC
  bool saturation = true;             // at the peak effort
  bool derating = true;               // by the windings' temperature
  bool compliance = true;             // between motors and mechanism
  bool position_quantisation = true;  // encoders
  bool homing_error = true;

  static constexpr Imperfections none() {
    return {false, false, false, false, false, false, false,
            false, false, false, false, false, false};
  }
};

/// Figures of one kind of actuator. Units: N, m for sliders; N m, rad for rings, at the ring.
/// Those of Stribeck, of cogging and of the transmission are assumptions.
struct ActuatorSettings {
  double peak = 0.0;            // [N, N m]
  double continuous = 0.0;      // [N, N m], for as long as one likes
  double viscous = 0.0;         // [N s/m, N m s/rad]
  double coulomb = 0.0;         // [N, N m]
  double stribeck_speed = 1.0;  // [m/s, rad/s]
  double ripple_pitch = 1.0;    // [m, rad]
  double cogging = 0.0;         // amplitude [N, N m]
  double cogging_pitch = 1.0;   // [m, rad]
  double resolution = 0.0;      // of the encoder [m, rad]
  double homing_low = 0.0;      // magnitude of the homing error [m, rad]
  double homing_high = 0.0;
  double stiffness = 0.0;      // between motor and mechanism [N/m, N m/rad]
  double motor_inertia = 0.0;  // on the motor's side of it [kg, kg m^2], part of the axis' own
};

/// Of windings and magnets; but for the continuous effort of the actuators, assumptions.
struct ThermalSettings {
  double rise = 80.0;           // [K] of a winding at the continuous effort, in the end
  double time = 60.0;           // [s] of a winding
  double derating_start = 0.8;  // share of the rise at which the limit begins to fall
  double magnet_share = 0.5;    // of a winding's rise that reaches its magnets
  double magnet_time = 600.0;   // [s]
  double gain_loss = 1e-3;      // [1/K] of the magnets
};

struct LaparoscopeDriveSettings {
  // Together the stiffnesses make 3000 N/mm of a lateral force at E in the neutral pose.
  ActuatorSettings slider{.peak = 200.0,
                          .continuous = 60.0,
                          .viscous = 8.0,
                          .coulomb = 0.35,
                          .stribeck_speed = 2e-3,
                          .ripple_pitch = 25.6e-3,
                          .cogging = 0.05,
                          .cogging_pitch = 12.8e-3,
                          .resolution = 2e-6,
                          .homing_low = 0.1e-3,
                          .homing_high = 0.2e-3,
                          .stiffness = 8e6,
                          .motor_inertia = 0.160};
  ActuatorSettings ring{.peak = 12.0,
                        .continuous = 2.7,
                        .viscous = 0.06,
                        .coulomb = 0.013,
                        .stribeck_speed = 20e-3,
                        .ripple_pitch = 32e-3,
                        .cogging = 1e-3,
                        .cogging_pitch = 16e-3,
                        .resolution = 0.00010226538585904274,  // 2 pi / (4*1024*15)
                        .homing_low = 0.0,
                        .homing_high = 1e-3,
                        .stiffness = 100e3,
                        .motor_inertia = 15.0 * 15.0 * 1.42e-5};
  ThermalSettings thermal = {};
  int dac_bits = 14;                   // over +-peak
  double gain = 0.9655;                // mean of the six, unless gain_error is off
  double gain_spread = 0.004;          // each lies within gain +- this
  double ripple = 0.007;               // amplitude relative to the effort
  double static_friction = 1.2;        // relative to the Coulomb friction
  double transmission_damping = 0.05;  // of the critical one
};

/// One figure of the sliders and one of the rings, for the six axes.
inline Vector6d both(double slider, double ring) {
  return (Vector6d() << slider, slider, slider, ring, ring, ring).finished();
}

/// @throw std::invalid_argument naming the value and what is allowed.
void validate(const LaparoscopeDriveSettings& settings);

}  // namespace trocar
