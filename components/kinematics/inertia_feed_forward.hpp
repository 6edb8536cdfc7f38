// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/kinematics/laparoscope_dynamics.hpp"
#include "components/kinematics/laparoscope_parameters.hpp"
#include "components/kinematics/laparoscope_units.hpp"
#include "framework/component.hpp"

namespace trocar {

/// The effort that a known motion of the laparoscope's axes needs besides weight and friction:
///
///   tau = M(q) q'' + c(q, q')
///
/// by the rigid-body model of LaparoscopeDynamics. A position at which the mechanism cannot be
/// assembled is a failure.
class InertiaFeedForward final : public Component {
 public:
  /// @throw std::invalid_argument for a geometry that cannot be built.
  void configure(const Setup& setup) override;
  void step(const Tick& tick) RT_SAFE override;

  Input<Joints> position{
      this, "position", {.unit = laparoscope_position_units, .doc = "of the axes"}};
  Input<Joints> velocity{
      this, "velocity", {.unit = laparoscope_velocity_units, .doc = "of the axes"}};
  Input<Joints> acceleration{
      this,
      "acceleration",
      {.unit = "m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2", .doc = "of the axes"}};
  Output<Joints> effort{
      this, "effort", {.unit = laparoscope_effort_units, .doc = "that this motion needs"}};

  Parameter<double> share{
      this,
      "share",
      {.initial = "1", .min = "0", .max = "1", .doc = "of it that is fed forward; 0 for none"}};
  LaparoscopeGeometryParameters geometry{this};
  LaparoscopeMassParameters masses{this};

 private:
  std::optional<LaparoscopeDynamics> dynamics_;
};

}  // namespace trocar
