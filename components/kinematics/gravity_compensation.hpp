// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/kinematics/laparoscope_gravity.hpp"
#include "components/kinematics/laparoscope_parameters.hpp"
#include "components/kinematics/laparoscope_units.hpp"
#include "framework/component.hpp"

namespace trocar {

/// The effort that holds the laparoscope's own weight, for a device's `hold`:
///
///   tau = dV/dq,   g = R_mount^T (0, 0, -9.80665 m/s^2) in the device's base frame
///
/// A position at which the mechanism cannot be assembled is a failure.
class GravityCompensation final : public Component {
 public:
  /// @throw std::invalid_argument for a geometry that cannot be built.
  void configure(const Setup& setup) override;
  void step(const Tick& tick) RT_SAFE override;

  Input<Joints> position{
      this, "position", {.unit = laparoscope_position_units, .doc = "of the axes"}};
  Output<Joints> effort{
      this, "effort", {.unit = laparoscope_effort_units, .doc = "that holds the weight"}};

  MountParameter mount{this};
  LaparoscopeGeometryParameters geometry{this};
  LaparoscopeMassParameters masses{this};

 private:
  std::optional<LaparoscopeModel> model_;
  std::optional<LaparoscopeGravity> weight_;
  Eigen::Vector3d gravity_ = standard_gravity;  // in the device's base frame
};

}  // namespace trocar
