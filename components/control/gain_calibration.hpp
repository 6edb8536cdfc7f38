// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_units.hpp"
#include "framework/component.hpp"

namespace trocar {

/// Commands for drives that give less or more than they are told:
///
///   effort_i = wanted_i / gain_i
///
/// with the gains that an identification found. Exact as far as they are.
class GainCalibration final : public Component {
 public:
  /// @throw std::invalid_argument for gains that are not six, or far from 1.
  void configure(const Setup& setup) override;
  void step(const Tick& tick) RT_SAFE override;

  Input<Joints> wanted{
      this, "wanted", {.unit = laparoscope_effort_units, .doc = "that the axes are to make"}};
  Output<Joints> effort{
      this, "effort", {.unit = laparoscope_effort_units, .doc = "to ask the drives for"}};

  Parameter<Joints> gain{this,
                         "gain",
                         {.initial = "1, 1, 1, 1, 1, 1",
                          .min = "0",
                          .max = "2",
                          .doc = "effort made / effort asked for, of each axis, 0.5–2"}};

 private:
  Eigen::Matrix<double, 6, 1> inverse_ = Eigen::Matrix<double, 6, 1>::Ones();
};

}  // namespace trocar
