// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_units.hpp"
#include "framework/component.hpp"

namespace trocar {

/// The effort of the axes that renders forces and moments at the tool's sites. This is the one
/// place where forces are shifted along the tool.
///
///   F = sum (f; (X - E) x f + m),   tau = J^T F          all in the device's base frame
///
/// f and m are what the device exerts on the hand; without any, tau = 0.
class LaparoscopeStatics final : public Component {
 public:
  void configure(const Setup& setup) override;
  void step(const Tick& tick) RT_SAFE override;

  Input<Jacobian> jacobian{
      this,
      "jacobian",
      {.frame = "device", .doc = "twist at E from the axes' velocities", .axes = 6}};
  Input<Vector3> origin{this, "origin", point("E, about which moments are taken")};
  Input<Vector3> tip_at{this, "tip_at", point("where the tip's forces act")};
  Input<Vector3> incision_at{this, "incision_at", point("where the incision's forces act")};
  Input<Vector3> handle_at{this, "handle_at", point("where the handle's forces act")};
  Inputs<Vector3> tip_force{this, "tip_force", force("at the tip")};
  Inputs<Vector3> incision_force{this, "incision_force", force("at the incision")};
  Inputs<Vector3> handle_force{this, "handle_force", force("at the handle")};
  Inputs<Vector3> tip_moment{this, "tip_moment", moment("at the tip")};
  Inputs<Vector3> incision_moment{this, "incision_moment", moment("at the incision")};
  Inputs<Vector3> handle_moment{this, "handle_moment", moment("at the handle")};

  Output<Joints> effort{
      this, "effort", {.unit = laparoscope_effort_units, .doc = "of the axes, to be rendered"}};
  Output<Wrench> wrench{
      this, "wrench", {.frame = "device", .doc = "of all forces together, moment about E"}};

 private:
  static PortOptions point(const char* doc) { return {.unit = "m", .frame = "device", .doc = doc}; }
  static PortOptions force(const char* doc) { return {.unit = "N", .frame = "device", .doc = doc}; }
  static PortOptions moment(const char* doc) {
    return {.unit = "N m", .frame = "device", .doc = doc};
  }
};

}  // namespace trocar
