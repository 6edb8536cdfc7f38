// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "components/kinematics/laparoscope_units.hpp"
#include "framework/component.hpp"

namespace trocar {

/// Dry friction from the position alone, without a velocity's sign: a bristle of length d that the
/// axis drags along.
///
///   z = q - w,   |z| <= d: w stays,   else w = q - d sgn(z);   f = F_c z / d
///
/// At rest q, and with it f, stays: nothing chatters, whatever the noise of a velocity. Its work
/// over any path is at most F_c times the path, so that a device with more dry friction than F_c
/// takes back what this puts in. (Hayward & Armstrong, Experimental Robotics VI, 2000; here with
/// the sign of what helps the motion.)
struct DraggedBristle {
  double length = 1e-3;  // d [m, rad], > 0
  double tail = 0.0;     // w
  void reset(double q) RT_SAFE { tail = q; }
  /// z / d in [-1, 1].
  double drag(double q) RT_SAFE {
    const double z = q - tail;
    if (z > length) tail = q - length;
    if (z < -length) tail = q + length;
    return (q - tail) / length;
  }
};

/// Takes off most of the friction of the laparoscope's axes:
///
///   effort_i = share (F_c,i z_i / d_i + b_i v_i)       share < 1
///
/// `position` and `velocity` are the measured ones, or those of a motion that is known beforehand.
class FrictionCompensation final : public Component {
 public:
  void configure(const Setup& setup) override;
  void start() override { started_ = false; }
  void step(const Tick& tick) RT_SAFE override;

  Input<Joints> position{
      this, "position", {.unit = laparoscope_position_units, .doc = "of the axes"}};
  Input<Joints> velocity{this,
                         "velocity",
                         {.unit = laparoscope_velocity_units,
                          .doc = "of the axes; without it only dry friction is taken off",
                          .optional = true}};
  Output<Joints> effort{
      this, "effort", {.unit = laparoscope_effort_units, .doc = "that helps the motion"}};

  Parameter<double> share{
      this,
      "share",
      {.initial = "0.9", .min = "0", .max = "0.98", .doc = "of the friction that is taken off"}};
  Parameter<Vector3> slider_dry{
      this,
      "slider_dry",
      {.unit = "N", .initial = "0, 0, 0", .min = "0 N", .max = "20 N", .doc = "F_c of sliders"}};
  Parameter<Vector3> ring_dry{
      this,
      "ring_dry",
      {.unit = "N m", .initial = "0, 0, 0", .min = "0 N m", .max = "1 N m", .doc = "F_c of rings"}};
  Parameter<Vector3> slider_viscous{this,
                                    "slider_viscous",
                                    {.unit = "N s/m",
                                     .initial = "0, 0, 0",
                                     .min = "0 N s/m",
                                     .max = "200 N s/m",
                                     .doc = "b of sliders"}};
  Parameter<Vector3> ring_viscous{this,
                                  "ring_viscous",
                                  {.unit = "N m s/rad",
                                   .initial = "0, 0, 0",
                                   .min = "0 N m s/rad",
                                   .max = "2 N m s/rad",
                                   .doc = "b of rings"}};
  Parameter<double> slider_bristle{
      this,
      "slider_bristle",
      {.unit = "m", .initial = "20 um", .min = "1 um", .max = "1 mm", .doc = "d of sliders"}};
  Parameter<double> ring_bristle{this,
                                 "ring_bristle",
                                 {.unit = "rad",
                                  .initial = "0.5 mrad",
                                  .min = "0.01 mrad",
                                  .max = "20 mrad",
                                  .doc = "d of rings"}};

 private:
  std::array<DraggedBristle, 6> bristles_{};
  std::array<double, 6> dry_{};      // share F_c
  std::array<double, 6> viscous_{};  // share b
  bool started_ = false;
};

}  // namespace trocar
