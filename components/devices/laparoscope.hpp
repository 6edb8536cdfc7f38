// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/laparoscope_use_parameters.hpp"
#include "components/kinematics/laparoscope_parameters.hpp"
#include "framework/group.hpp"

namespace trocar {

/// The laparoscopic interface, ready for fixtures: device, velocity, kinematics, gravity
/// compensation and statics.
///
///   device.position → velocity → tool        weight.effort  → device.hold
///   device.position → tool, weight           statics.effort → device.effort
///   tool → statics ← forces at the sites tip, incision, handle
///
/// hand, start and ideal are the simulation's; loads from outside act on no real tool, so its sites
/// take none.
class Laparoscope final : public Group {
 public:
  void build(GroupScope& scope) override;

  Parameter<Choice> device{this,
                           "device",
                           {.initial = "simulated",
                            .doc = "what is behind the group: a simulation, or the device itself",
                            .choices = {"simulated", "hid"}}};
  Parameter<std::string> serial{
      this,
      "serial",
      {.initial = "any", .doc = "of the device itself, where several are attached"}};
  Parameter<std::string> path{
      this,
      "path",
      {.initial = "any", .doc = "of the device itself, or the socket of an emulated one"}};
  MountParameter mount{this};
  LaparoscopeSiteParameters sites{this};
  LaparoscopeUseParameters use{this};
};

}  // namespace trocar
