// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <stdexcept>
#include <string>

#include "components/devices/hid/device_state_machine.hpp"

namespace trocar::hid {
namespace {

constexpr double calm_speed = 20e-3;    // [m/s], rule 6
constexpr double calm_force = 1.0;      // [N], rule 6
constexpr double homing_speed = 20e-3;  // [m/s], rule 9
constexpr double homing_force = 2.0;    // [N], rule 9

double positive(double value, const char* what, std::size_t axis) {
  if (value > 0.0 && std::isfinite(value)) return value;
  throw std::invalid_argument(std::string(what) + " of axis " + std::to_string(axis) + " is " +
                              std::to_string(value) + "; it must be positive and finite");
}

}  // namespace

DeviceRules device_rules(const LimitsPage& limits, const CalibrationPage& calibration,
                         double ring_radius) {
  positive(ring_radius, "the ring's radius, for the rule", 3);
  DeviceRules rules;
  for (std::size_t i = 0; i < axes; ++i) {
    const double arm = i < 3 ? 1.0 : ring_radius;
    const double unit = positive(std::abs(static_cast<double>(calibration.unit[i])), "unit", i);
    const double peak = positive(static_cast<double>(limits.peak[i]), "peak effort", i);
    const double speed = positive(static_cast<double>(limits.speed[i]), "speed", i);
    rules.speed[i] = speed / unit;
    rules.calm_speed[i] = calm_speed / arm / unit;
    rules.homing_speed[i] = homing_speed / arm / unit;
    rules.calm_effort[i] = calm_force * arm / peak * effort_max;
    rules.homing_effort[i] = static_cast<std::int16_t>(
        std::floor(std::min(1.0, homing_force * arm / peak) * effort_max));
  }
  return rules;
}

}  // namespace trocar::hid
