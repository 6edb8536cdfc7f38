// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_parameters.hpp"

#include "components/kinematics/laparoscope_gravity.hpp"

namespace trocar {

LaparoscopeGeometry LaparoscopeGeometryParameters::value() const {
  return {.tool_length = *tool_length,
          .ring_plane = *ring_plane,
          .ring_radius = *ring_radius,
          .base_radius = *base_radius,
          .platform_radius = *platform_radius,
          .link_length = *link_length,
          .roll = static_cast<RollModel>(roll->index)};
}

LaparoscopeMasses LaparoscopeMassParameters::value() const {
  LaparoscopeMasses masses;
  masses.slider = *slider_mass;
  masses.link_pair = *link_mass;
  masses.platform = *platform_mass;
  masses.tool = *tool_mass;
  masses.tool_centre = *tool_centre;
  masses.end_effector = *gimbal_mass;
  masses.pin = *pin_mass;
  return masses;
}

Eigen::Vector3d MountParameter::gravity() const {
  return mount->eigen().conjugate() * standard_gravity;
}

}  // namespace trocar
