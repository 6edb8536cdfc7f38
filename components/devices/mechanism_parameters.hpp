// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/declare_number.hpp"
#include "components/devices/laparoscope_plant.hpp"

namespace trocar {

/// What keeps the simulated mechanism from being its model, as parameters.
struct MechanismParameters {
  explicit MechanismParameters(ParameterSet* set) : owner(set) {}
  void apply(LaparoscopePlantSettings& settings) const;

  ParameterSet* owner;
  Parameter<bool> friction = yes("friction", "viscous and dry, in every axis");
  Parameter<double> slider_viscous =
      number("slider_viscous", "N s/m", "8 N s/m", "0 N s/m", "200 N s/m", "friction of a slider");
  Parameter<double> slider_coulomb =
      number("slider_coulomb", "N", "0.35 N", "0 N", "20 N", "dry friction of a slider");
  Parameter<double> ring_viscous = number("ring_viscous", "N m s/rad", "0.06 N m s/rad",
                                          "0 N m s/rad", "5 N m s/rad", "friction of a ring");
  Parameter<double> ring_coulomb =
      number("ring_coulomb", "N m", "0.013 N m", "0 N m", "1 N m", "dry friction of a ring");

  Parameter<bool> stribeck = yes("stribeck", "dry friction is higher near rest");
  Parameter<double> static_friction =
      number("static_friction", "", "1.2", "1", "5", "of the dry friction in motion");
  Parameter<double> slider_stribeck_speed =
      number("slider_stribeck_speed", "m/s", "2 mm/s", "0.1 mm/s", "1 m/s",
             "at which 37 % of the excess is left");
  Parameter<double> ring_stribeck_speed =
      number("ring_stribeck_speed", "rad/s", "0.02 rad/s", "0.001 rad/s", "10 rad/s",
             "at which 37 % of the excess is left");

  Parameter<bool> compliance = yes("compliance", "transmissions yield, motors move by themselves");
  Parameter<double> slider_stiffness = number("slider_stiffness", "N/m", "8000 N/mm", "10 N/mm",
                                              "100000 N/mm", "between a slider and its motor");
  Parameter<double> ring_stiffness =
      number("ring_stiffness", "N m/rad", "100 kN m/rad", "0.1 kN m/rad", "10000 kN m/rad",
             "between a ring and its motor");
  Parameter<double> transmission_damping =
      number("transmission_damping", "%", "5 %", "0 %", "50 %", "of the critical one");
  Parameter<double> slider_motor_mass = number("slider_motor_mass", "kg", "160 g", "1 g", "20 kg",
                                               "share of slider_mass on its motor's side");
  Parameter<double> ring_motor_inertia =
      number("ring_motor_inertia", "kg m^2", "0.003195 kg m^2", "1e-5 kg m^2", "1 kg m^2",
             "on its motor's side, at the ring");

  Parameter<bool> homing_error = yes("homing_error", "the zeros of the encoders are off");
  Parameter<double> slider_homing_error =
      number("slider_homing_error", "m", "0.2 mm", "0 mm", "5 mm", "at most; at least half of it");
  Parameter<double> ring_homing_error =
      number("ring_homing_error", "rad", "1 mrad", "0 mrad", "100 mrad", "at most");

  Parameter<bool> weight_error = yes("weight_error", "parts weigh not quite what they should");
  Parameter<double> tool_mass_error = error("tool_mass_error", "-5 %", "of tool_mass");
  Parameter<double> tool_centre_error = error("tool_centre_error", "-3 %", "of tool_centre");
  Parameter<double> slider_mass_error = error("slider_mass_error", "1 %", "of slider_mass");

 private:
  Parameter<double> number(const char* name, const char* unit, const char* initial, const char* min,
                           const char* max, const char* doc) {
    return declare_number(owner, name, {unit, initial, min, max, doc});
  }
  /// Of the nominal value against the device's own, as weighing the parts leaves it.
  Parameter<double> error(const char* name, const char* initial, const char* doc) {
    return number(name, "%", initial, "-50 %", "50 %", doc);
  }
  Parameter<bool> yes(const char* name, const char* doc) {
    return declare_switch(owner, name, doc);
  }
};

}  // namespace trocar
