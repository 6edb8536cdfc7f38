// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope_loads.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace trocar {

AssemblyStatus LaparoscopeLoads::update(const Vector6d& position) RT_SAFE {
  LaparoscopeConfiguration c;
  const AssemblyStatus status = model_.forward(position, c);
  if (status != AssemblyStatus::ok) return status;
  tool_ = c.tool;
  jacobian_ = model_.rates(c).jacobian;
  wrench_from_effort_ = jacobian_.transpose().inverse();
  return status;
}

LaparoscopeLoads::Loads LaparoscopeLoads::of(const Vector6d& effort) const RT_SAFE {
  const Vector6d wrench = wrench_from_effort_ * effort;
  const Eigen::Vector3d f = wrench.head<3>(), m = wrench.tail<3>(), t = tool_.axis;
  const double l = model_.geometry().tool_length;
  Loads loads;
  loads.handle_force = f;
  loads.handle_moment = m - handle_offset_ * t.cross(f);
  loads.gimbal = (m + l * t.cross(f)).cross(t) / tool_.engagement;
  loads.delta = f - loads.gimbal;
  return loads;
}

double LaparoscopeLoads::handle_speed(const Vector6d& velocity) const RT_SAFE {
  const Vector6d twist = jacobian_ * velocity;
  return velocity_at(tool_, point_on_tool(tool_, handle_offset_), twist).norm();
}

}  // namespace trocar
