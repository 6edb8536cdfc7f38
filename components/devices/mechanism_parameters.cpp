// SPDX-License-Identifier: Apache-2.0
#include "components/devices/mechanism_parameters.hpp"

namespace trocar {

void MechanismParameters::apply(LaparoscopePlantSettings& settings) const {
  LaparoscopeDriveSettings& drive = settings.drive;
  ActuatorSettings& slider = drive.slider;
  slider.viscous = *slider_viscous;
  slider.coulomb = *slider_coulomb;
  slider.stribeck_speed = *slider_stribeck_speed;
  slider.stiffness = *slider_stiffness;
  slider.motor_inertia = *slider_motor_mass;
  slider.homing_low = 0.5 * *slider_homing_error;
  slider.homing_high = *slider_homing_error;
  ActuatorSettings& ring = drive.ring;
  ring.viscous = *ring_viscous;
  ring.coulomb = *ring_coulomb;
  ring.stribeck_speed = *ring_stribeck_speed;
  ring.stiffness = *ring_stiffness;
  ring.motor_inertia = *ring_motor_inertia;
  ring.homing_low = 0.0;
  ring.homing_high = *ring_homing_error;
  drive.static_friction = *static_friction;
  drive.transmission_damping = *transmission_damping;

  Imperfections& with = settings.imperfections;
  with.viscous_friction = with.coulomb_friction = *friction;
  with.stribeck = *stribeck;
  with.compliance = *compliance;
  with.homing_error = *homing_error;

  // The masses that the settings have are nominal, so it is the device that differs.
  if (!*weight_error) return;
  settings.masses.tool /= 1.0 + *tool_mass_error;
  settings.masses.tool_centre /= 1.0 + *tool_centre_error;
  settings.masses.slider /= 1.0 + *slider_mass_error;
}

}  // namespace trocar
