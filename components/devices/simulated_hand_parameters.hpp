// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/declare_number.hpp"
#include "components/devices/simulated_hand.hpp"

namespace trocar {

/// HandSettings as parameters. A hand that pushes moves its target along a path and back, over and
/// over.
struct SimulatedHandParameters {
  explicit SimulatedHandParameters(ParameterSet* set) : owner(set) {}
  /// @throw std::invalid_argument for a direction without length.
  HandSettings value(HandMode mode) const;

  ParameterSet* owner;
  Parameter<Vector3> push_direction{
      owner, "push_direction", {.initial = "0, 0, 1", .doc = "of any length"}};
  Parameter<double> push_distance =
      number("push_distance", "m", "60 mm", "0 mm", "300 mm",
             "that the hand's target moves; the tool stays behind it");
  Parameter<Vector3> push_bow{
      owner,
      "push_bow",
      {.unit = "m", .initial = "0, 0, 0", .doc = "of the path off the straight line, half way"}};
  Parameter<double> push_start = time("push_start", "0.5 s", "0 s", "before it begins");
  Parameter<double> push_time = time("push_time", "1.5 s", "0.05 s", "of each way");
  Parameter<double> push_dwell = time("push_dwell", "3 s", "0 s", "at either end");
  Parameter<double> hand_mass =
      number("hand_mass", "kg", "300 g", "0 kg", "5 kg", "that moves with the tool");
  Parameter<double> hand_damping = number("hand_damping", "N s/m", "8 N s/m", "0 N s/m",
                                          "200 N s/m", "towards its target, when firm");
  Parameter<double> hand_stiffness = number("hand_stiffness", "N/m", "250 N/m", "0 N/m", "5000 N/m",
                                            "towards its target, when firm");
  Parameter<double> hand_rotational_damping =
      number("hand_rotational_damping", "N m s/rad", "0.02 N m s/rad", "0 N m s/rad", "1 N m s/rad",
             "against turning, when firm");
  Parameter<double> hand_rotational_stiffness =
      number("hand_rotational_stiffness", "N m/rad", "1 N m/rad", "0 N m/rad", "50 N m/rad",
             "towards the orientation that it grasped, when firm");
  Parameter<double> relaxed_grip = number("relaxed_grip", "%", "30 %", "0 %", "100 %",
                                          "a relaxed hand's share of stiffness and damping");

 private:
  Parameter<double> number(const char* name, const char* unit, const char* initial, const char* min,
                           const char* max, const char* doc) {
    return declare_number(owner, name, {unit, initial, min, max, doc});
  }
  Parameter<double> time(const char* name, const char* initial, const char* min, const char* doc) {
    return number(name, "s", initial, min, "3600 s", doc);
  }
};

}  // namespace trocar
