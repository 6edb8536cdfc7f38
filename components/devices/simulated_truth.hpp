// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_units.hpp"
#include "framework/component.hpp"

namespace trocar {

/// What only a simulation knows of the laparoscope, as its outputs `truth.…`.
struct SimulatedTruth {
  explicit SimulatedTruth(Component* component) : owner(component) {}

  Component* owner;
  Output<Joints> position{
      owner, "truth.position", {.unit = laparoscope_position_units, .doc = "where the axes are"}};
  Output<Joints> velocity{
      owner, "truth.velocity", {.unit = laparoscope_velocity_units, .doc = "of the axes"}};
  Output<Joints> motor_position{owner,
                                "truth.motor_position",
                                {.unit = laparoscope_position_units,
                                 .doc = "where their motors are, behind the transmissions"}};
  Output<PointMotion> tip{owner, "truth.tip", {.frame = "device", .doc = "motion of E"}};
  Output<Vector3> hand_force{
      owner,
      "truth.hand_force",
      {.unit = "N", .frame = "device", .doc = "of the hand on the tool at E"}};
  Output<Joints> temperature{
      owner,
      "truth.temperature",
      {.unit = "K, K, K, K, K, K", .doc = "of the motors' windings, above the room's"}};
  Output<Joints> gain{
      owner,
      "truth.gain",
      {.unit = "1, 1, 1, 1, 1, 1", .doc = "that the mechanism gets of what is sent"}};
};

}  // namespace trocar
