// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"

namespace lab {

using namespace trocar;

/// A ball that pushes out what enters it:
///
///   depth = max(0, r - |p - c|)                 [m]
///   force = k depth (p - c) / |p - c|           [N], zero outside and in the very centre
struct SoftBall {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  // c [m]
  double radius = 0.02;                              // r [m], > 0
  double stiffness = 500.0;                          // k [N/m], >= 0

  double depth(const Eigen::Vector3d& position) const RT_SAFE {
    const double inside = radius - (position - center).norm();
    return inside > 0.0 ? inside : 0.0;
  }
  Eigen::Vector3d force(const Eigen::Vector3d& position) const RT_SAFE {
    const Eigen::Vector3d out = position - center;
    const double distance = out.norm();
    if (!(distance > 1e-9)) return Eigen::Vector3d::Zero();
    return stiffness * depth(position) / distance * out;
  }
};

/// A SoftBall with ports, in the device's base frame.
class Ball final : public Component {
 public:
  Ball() { place({.position = &position, .force = &force}); }
  void configure(const Setup&) override { ball_.center = center->eigen(); }
  void step(const Tick&) RT_SAFE override {
    ball_.radius = *radius;
    ball_.stiffness = *stiffness;
    *force = ball_.force(position->eigen());
    *depth = ball_.depth(position->eigen());
  }

  Input<Vector3> position{
      this, "position", {.unit = "m", .frame = "device", .doc = "of the point that touches"}};
  Output<Vector3> force{
      this, "force", {.unit = "N", .frame = "device", .doc = "on what touches the ball"}};
  Output<double> depth{this, "depth", {.unit = "m", .doc = "inside the ball, 0 outside"}};

  Parameter<Vector3> center{
      this, "center", {.unit = "m", .initial = "0, 0, 110 mm", .doc = "of the ball"}};
  Parameter<double> radius{
      this,
      "radius",
      {.unit = "m", .initial = "20 mm", .min = "1 mm", .max = "50 mm", .doc = "of the ball"}};
  Parameter<double> stiffness{this,
                              "stiffness",
                              {.unit = "N/m",
                               .initial = "0.5 N/mm",
                               .min = "0 N/mm",
                               .max = "5 N/mm",
                               .doc = "force for each depth",
                               .live = true}};

 private:
  SoftBall ball_;
};

}  // namespace lab
