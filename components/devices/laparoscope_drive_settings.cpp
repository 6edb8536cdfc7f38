// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope_drive_settings.hpp"

#include <cmath>
#include <string>

#include "components/requirement.hpp"

namespace trocar {
namespace {

void require_of_drive(bool holds, const std::string& what, double value, const char* allowed) {
  require(holds, "drive: " + what, value, std::string("needs ") + allowed);
}

void at_least_0(const char* what, double value) {
  require_of_drive(value >= 0.0 && std::isfinite(value), what, value, "a value of at least 0");
}

void above_0(const char* what, double value) {
  require_of_drive(value > 0.0 && std::isfinite(value), what, value, "a value above 0");
}

void validate(const ActuatorSettings& a) {
  require_of_drive(a.peak > 0.0, "peak", a.peak, "an effort above 0, e.g. 200 N");
  require_of_drive(a.continuous > 0.0 && a.continuous <= a.peak, "continuous", a.continuous,
                   "an effort above 0 and at most the peak");
  at_least_0("viscous", a.viscous);
  at_least_0("coulomb", a.coulomb);
  above_0("stribeck_speed", a.stribeck_speed);
  above_0("ripple_pitch", a.ripple_pitch);
  at_least_0("cogging", a.cogging);
  above_0("cogging_pitch", a.cogging_pitch);
  require_of_drive(a.resolution > 0.0, "resolution", a.resolution, "a value above 0, e.g. 2e-6 m");
  at_least_0("homing_low", a.homing_low);
  require_of_drive(a.homing_high >= a.homing_low, "homing_high", a.homing_high,
                   "at least the value of homing_low");
  above_0("stiffness", a.stiffness);
  above_0("motor_inertia", a.motor_inertia);
}

void validate(const ThermalSettings& t) {
  above_0("thermal.rise", t.rise);
  above_0("thermal.time", t.time);
  require_of_drive(t.derating_start >= 0.0 && t.derating_start < 1.0, "thermal.derating_start",
                   t.derating_start, "a value from 0 to below 1");
  at_least_0("thermal.magnet_share", t.magnet_share);
  above_0("thermal.magnet_time", t.magnet_time);
  at_least_0("thermal.gain_loss", t.gain_loss);
}

}  // namespace

void validate(const LaparoscopeDriveSettings& s) {
  validate(s.slider);
  validate(s.ring);
  validate(s.thermal);
  require_of_drive(s.dac_bits >= 2 && s.dac_bits <= 32, "dac_bits", s.dac_bits, "2 to 32 bits");
  require_of_drive(s.gain > 0.0, "gain", s.gain, "a value above 0, e.g. 0.9655");
  require_of_drive(s.gain_spread >= 0.0 && s.gain_spread < s.gain, "gain_spread", s.gain_spread,
                   "a value of at least 0 and below gain");
  require_of_drive(s.ripple >= 0.0 && s.ripple < 1.0, "ripple", s.ripple,
                   "a value from 0 to below 1");
  require_of_drive(s.static_friction >= 1.0, "static_friction", s.static_friction,
                   "a value of at least 1");
  require_of_drive(s.transmission_damping >= 0.0 && s.transmission_damping <= 0.5,
                   "transmission_damping", s.transmission_damping, "a value from 0 to 0.5");
}

}  // namespace trocar
