// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/kinematics/laparoscope_dynamics.hpp"
#include "components/kinematics/laparoscope_parameters.hpp"
#include "components/kinematics/laparoscope_units.hpp"
#include "framework/component.hpp"

namespace trocar {

/// How the axes of a LaparoscopeModel move when its tip does and the tool does not turn.
struct AxesMotion {
  Vector6d position = Vector6d::Zero();
  Vector6d velocity = Vector6d::Zero();
  Vector6d acceleration = Vector6d::Zero();
};

/// The motion of the laparoscope's axes that makes its tip follow `offset` from the pose of the
/// first step, the tool's orientation kept:
///
///   q = IK(E_0 + offset, R_0),   q' = J^-1 (v; 0),   q'' = J^-1 ((a; 0) - J' q')
///
/// A tip that cannot be reached is a failure.
class ToolReference final : public Component {
 public:
  /// @throw std::invalid_argument for a geometry that cannot be built.
  void configure(const Setup& setup) override;
  void start() override { started_ = false; }
  void step(const Tick& tick) RT_SAFE override;

  Input<Joints> position{
      this, "position", {.unit = laparoscope_position_units, .doc = "where the axes begin"}};
  Input<Vector3> offset{
      this, "offset", {.unit = "m", .frame = "device", .doc = "of the tip from there"}};
  Input<Vector3> tip_velocity{
      this, "tip_velocity", {.unit = "m/s", .frame = "device", .doc = "of that"}};
  Input<Vector3> tip_acceleration{
      this, "tip_acceleration", {.unit = "m/s^2", .frame = "device", .doc = "of that"}};
  Output<Joints> axes{
      this, "axes", {.unit = laparoscope_position_units, .doc = "goal of the axes"}};
  Output<Joints> axes_velocity{
      this, "axes_velocity", {.unit = laparoscope_velocity_units, .doc = "of that"}};
  Output<Joints> axes_acceleration{
      this,
      "axes_acceleration",
      {.unit = "m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2", .doc = "of that"}};

  LaparoscopeGeometryParameters geometry{this};

 private:
  std::optional<LaparoscopeDynamics> dynamics_;
  PoseCoordinates begin_{};
  bool started_ = false;
};

}  // namespace trocar
