// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/laparoscope_plant.hpp"
#include "framework/parameter_set.hpp"

/// @file
/// The simulated laparoscope's settings as parameters.

namespace trocar {

/// What a newcomer sets; the group Laparoscope offers the same.
struct LaparoscopeUseParameters {
  explicit LaparoscopeUseParameters(ParameterSet* set) : owner(set) {}

  ParameterSet* owner;
  Parameter<Choice> hand{owner,
                         "hand",
                         {.initial = "none",
                          .doc = "grasps the tool at E: nobody, one that holds, one that pushes",
                          .choices = {"none", "hold", "push"}}};
  Parameter<Choice> start{owner,
                          "start",
                          {.initial = "engaged",
                           .doc = "engaged: held and at rest; cold: on its brake until held",
                           .choices = {"engaged", "cold"}}};
  Parameter<bool> ideal{
      owner,
      "ideal",
      {.initial = "false", .doc = "no friction, no errors, no quantisation: the model itself"}};
};

/// A hand that pushes moves its target by the distance and back, over and over.
struct SimulatedHandParameters {
  explicit SimulatedHandParameters(ParameterSet* set) : owner(set) {}
  /// @throw std::invalid_argument for a direction without length.
  HandSettings value(HandMode mode) const;

  ParameterSet* owner;
  Parameter<Vector3> push_direction{
      owner, "push_direction", {.initial = "0, 0, 1", .doc = "of any length"}};
  Parameter<double> push_distance{
      owner,
      "push_distance",
      {.unit = "m",
       .initial = "60 mm",
       .min = "0 mm",
       .max = "300 mm",
       .doc = "that the hand's target moves; the tool stays behind it"}};
  Parameter<double> push_start = time("push_start", "0.5 s", "0 s", "before it begins");
  Parameter<double> push_time = time("push_time", "1.5 s", "0.05 s", "of each way");
  Parameter<double> push_dwell = time("push_dwell", "3 s", "0 s", "at either end");
  Parameter<double> hand_mass{owner,
                              "hand_mass",
                              {.unit = "kg",
                               .initial = "300 g",
                               .min = "0 kg",
                               .max = "5 kg",
                               .doc = "that moves with the tool"}};
  Parameter<double> hand_damping{owner,
                                 "hand_damping",
                                 {.unit = "N s/m",
                                  .initial = "8 N s/m",
                                  .min = "0 N s/m",
                                  .max = "200 N s/m",
                                  .doc = "towards its target"}};
  Parameter<double> hand_stiffness{owner,
                                   "hand_stiffness",
                                   {.unit = "N/m",
                                    .initial = "250 N/m",
                                    .min = "0 N/m",
                                    .max = "5000 N/m",
                                    .doc = "towards its target"}};

 private:
  Parameter<double> time(const char* name, const char* initial, const char* min, const char* doc) {
    return {
        owner, name, {.unit = "s", .initial = initial, .min = min, .max = "3600 s", .doc = doc}};
  }
};

/// What keeps the simulated device from being its model. `ideal` turns all of it off.
struct ImperfectionParameters {
  explicit ImperfectionParameters(ParameterSet* set) : owner(set) {}
  Imperfections value(bool ideal) const;
  /// The masses of a device that was meant to have the nominal ones.
  LaparoscopeMasses masses(const LaparoscopeMasses& nominal, bool ideal) const;

  ParameterSet* owner;
  Parameter<bool> friction = yes("friction", "viscous and dry, in every axis");
  Parameter<bool> gain_error = yes("gain_error", "drives give 0.9655 +- 0.004 of the command");
  Parameter<bool> ripple = yes("ripple", "drives ripple by 0.7 % along the way");
  Parameter<bool> quantisation = yes("quantisation", "encoders and amplifiers count in steps");
  Parameter<bool> homing_error = yes("homing_error", "0.1-0.2 mm and up to 1 mrad");
  Parameter<bool> weight_error = yes("weight_error", "parts weigh not quite what they should");

 private:
  Parameter<bool> yes(const char* name, const char* doc) {
    return {owner, name, {.initial = "true", .doc = doc}};
  }
};

}  // namespace trocar
