// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/kinematics/laparoscope_model.hpp"
#include "components/kinematics/laparoscope_parameters.hpp"
#include "components/kinematics/laparoscope_units.hpp"
#include "framework/component.hpp"

namespace trocar {

/// Where the laparoscope's tool is and how it moves, from the positions and velocities of its
/// axes. All of it in the device's base frame.
///
///   E, R = FK(q),   (vE; omega) = J q'
///   X = E + s t,    vX = vE + omega x (X - E)          for each site
///
/// A position at which the mechanism cannot be assembled is a failure.
class LaparoscopeKinematics final : public Component {
 public:
  /// Says how good its outputs are: one count of each axis through |J| of the neutral pose
  /// (A 65 mm behind the origin, B on the axis), the inputs' delay passed on.
  /// @throw std::invalid_argument for a geometry that cannot be built.
  void configure(const Setup& setup) override;
  void step(const Tick& tick) RT_SAFE override;

  Input<Joints> position{
      this, "position", {.unit = laparoscope_position_units, .doc = "of the axes"}};
  Input<Joints> velocity{this,
                         "velocity",
                         {.unit = laparoscope_velocity_units,
                          .doc = "of the axes; without it nothing moves",
                          .optional = true}};

  Output<PointMotion> tip{this, "tip", {.frame = "device", .doc = "motion of the tip"}};
  Output<PointMotion> incision{
      this, "incision", {.frame = "device", .doc = "motion of the tool's point in the incision"}};
  Output<PointMotion> handle{this, "handle", {.frame = "device", .doc = "motion of the handle"}};
  Output<Pose> pose{this, "pose", {.frame = "device", .doc = "of the tool: E and R"}};
  Output<Twist> twist{this, "twist", {.frame = "device", .doc = "of the tool at E"}};
  Output<Jacobian> jacobian{
      this,
      "jacobian",
      {.frame = "device", .doc = "twist at E from the axes' velocities", .axes = 6}};
  Output<Vector3> angles{
      this,
      "angles",
      {.unit = "rad", .doc = "alpha, beta: the tool projected onto n1n3, n2n3; theta: the ring"}};

  LaparoscopeGeometryParameters geometry{this};
  LaparoscopeSiteParameters sites{this};

 private:
  void declare_quality();

  std::optional<LaparoscopeModel> model_;
};

}  // namespace trocar
