// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_geometry.hpp"
#include "framework/parameter_set.hpp"

/// @file
/// The laparoscope's settings as parameters: one declaration for all components that need them.

namespace trocar {

/// LaparoscopeGeometry as parameters.
struct LaparoscopeGeometryParameters {
  explicit LaparoscopeGeometryParameters(ParameterSet* set) : owner(set) {}
  LaparoscopeGeometry value() const;

  ParameterSet* owner;
  Parameter<double> tool_length{
      owner,
      "tool_length",
      {.unit = "m", .initial = "150 mm", .min = "1 mm", .max = "2000 mm", .doc = "A to E"}};
  Parameter<double> ring_plane{owner,
                               "ring_plane",
                               {.unit = "m",
                                .initial = "20 mm",
                                .min = "-1000 mm",
                                .max = "1000 mm",
                                .doc = "height of the gimbal's plane along n3"}};
  Parameter<double> ring_radius{owner,
                                "ring_radius",
                                {.unit = "m",
                                 .initial = "90 mm",
                                 .min = "1 mm",
                                 .max = "1000 mm",
                                 .doc = "of the circle on which the rings' pins run"}};
  Parameter<double> base_radius{owner,
                                "base_radius",
                                {.unit = "m",
                                 .initial = "140 mm",
                                 .min = "1 mm",
                                 .max = "1000 mm",
                                 .doc = "of the circle on which the rails stand"}};
  Parameter<double> platform_radius{owner,
                                    "platform_radius",
                                    {.unit = "m",
                                     .initial = "40 mm",
                                     .min = "0 mm",
                                     .max = "1000 mm",
                                     .doc = "of the delta's platform, smaller than base_radius"}};
  Parameter<double> link_length{owner,
                                "link_length",
                                {.unit = "m",
                                 .initial = "210 mm",
                                 .min = "1 mm",
                                 .max = "2000 mm",
                                 .doc = "of the delta's links"}};
  Parameter<Choice> roll{owner,
                         "roll",
                         {.initial = "gimbal_outer_y",
                          .doc = "how the ring's angle becomes the tool's roll",
                          .choices = {"gimbal_outer_y", "gimbal_outer_x", "zero_torsion"}}};
};

/// LaparoscopeMasses as parameters.
struct LaparoscopeMassParameters {
  explicit LaparoscopeMassParameters(ParameterSet* set) : owner(set) {}
  LaparoscopeMasses value() const;

  ParameterSet* owner;
  Parameter<double> slider_mass = mass("slider_mass", "320 g", "of one slider");
  Parameter<double> link_mass = mass("link_mass", "24 g", "of both rods of one arm");
  Parameter<double> platform_mass = mass("platform_mass", "60 g", "of the delta's platform");
  Parameter<double> tool_mass = mass("tool_mass", "120 g", "of the tool");
  Parameter<double> tool_centre{owner,
                                "tool_centre",
                                {.unit = "m",
                                 .initial = "105 mm",
                                 .min = "-2000 mm",
                                 .max = "2000 mm",
                                 .doc = "of the tool's mass, from A along the tool"}};
  Parameter<double> gimbal_mass = mass("gimbal_mass", "110 g", "of spokes, gimbal and sleeve");
  Parameter<double> pin_mass = mass("pin_mass", "15 g", "of one ring's pin");

 private:
  Parameter<double> mass(const char* name, const char* initial, const char* doc) {
    return {
        owner, name, {.unit = "kg", .initial = initial, .min = "0 kg", .max = "20 kg", .doc = doc}};
  }
};

/// Where the named points of the tool lie: E + s t.
struct LaparoscopeSiteParameters {
  explicit LaparoscopeSiteParameters(ParameterSet* set) : owner(set) {}

  ParameterSet* owner;
  Parameter<double> tip_offset = offset("tip_offset", "of the tip from E along the tool");
  Parameter<double> incision_offset =
      offset("incision_offset", "of the incision from E along the tool");
  Parameter<double> handle_offset = offset("handle_offset", "of the handle from E along the tool");

 private:
  Parameter<double> offset(const char* name, const char* doc) {
    return {owner,
            name,
            {.unit = "m", .initial = "0 mm", .min = "-1000 mm", .max = "1000 mm", .doc = doc}};
  }
};

/// How the device's base stands relative to an upright one.
struct MountParameter {
  explicit MountParameter(ParameterSet* set) : owner(set) {}
  /// g in N: R_mount^T (0, 0, -9.80665) [m/s^2].
  Eigen::Vector3d gravity() const;

  ParameterSet* owner;
  Parameter<Rotation> mount{owner,
                            "mount",
                            {.unit = "deg",
                             .initial = "roll = 0, pitch = 0, yaw = 0",
                             .doc = "turn of the device's base from upright"}};
};

}  // namespace trocar
