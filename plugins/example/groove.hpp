// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "framework/component.hpp"

namespace example {

using namespace trocar;

/// A groove along the line c + s n, which pulls to its bottom and leaves the way along it free:
///
///   off   = (p - c) - n (n . (p - c))                       [m]
///   force = -off min(k, f_max / |off|)                      [N]
struct GrooveLaw {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();       // c [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // n, |n| = 1
  double stiffness = 500.0;                              // k [N/m], >= 0
  double limit = 3.0;                                    // f_max [N], >= 0

  Eigen::Vector3d off(const Eigen::Vector3d& position) const RT_SAFE {
    const Eigen::Vector3d from_point = position - point;
    return from_point - direction * direction.dot(from_point);
  }
  Eigen::Vector3d force(const Eigen::Vector3d& position) const RT_SAFE {
    const Eigen::Vector3d aside = off(position);
    const double pull = std::min(stiffness * aside.norm(), limit);
    return -pull * aside.stableNormalized();
  }
};

/// A GrooveLaw with ports, in the device's base frame.
class Groove final : public Component {
 public:
  Groove() { place({.position = &position, .force = &force}); }
  void configure(const Setup&) override {
    if (!(direction->eigen().norm() > 0.0))
      throw std::invalid_argument("direction: must not be zero, e.g. { 0, 0, 1 }");
    law_.point = point->eigen();
    law_.direction = direction->eigen().normalized();
  }
  void step(const Tick&) RT_SAFE override {
    law_.stiffness = *stiffness;
    law_.limit = *limit;
    *force = law_.force(position->eigen());
    *distance = law_.off(position->eigen()).norm();
  }

  Input<Vector3> position{
      this, "position", {.unit = "m", .frame = "device", .doc = "of the point that it guides"}};
  Output<Vector3> force{
      this, "force", {.unit = "N", .frame = "device", .doc = "on that point, to the line"}};
  Output<double> distance{this, "distance", {.unit = "m", .doc = "of the point from the line"}};

  Parameter<Vector3> point{
      this, "point", {.unit = "m", .initial = "0, 0, 110 mm", .doc = "on the line"}};
  Parameter<Vector3> direction{
      this, "direction", {.initial = "0, 0, 1", .doc = "of the line, of any length"}};
  Parameter<double> stiffness{this,
                              "stiffness",
                              {.unit = "N/m",
                               .initial = "0.5 N/mm",
                               .min = "0 N/mm",
                               .max = "5 N/mm",
                               .doc = "force for each distance",
                               .live = true}};
  Parameter<double> limit{this,
                          "limit",
                          {.unit = "N",
                           .initial = "3 N",
                           .min = "0 N",
                           .max = "10 N",
                           .doc = "of the force",
                           .live = true}};

 private:
  GrooveLaw law_;
};

}  // namespace example
