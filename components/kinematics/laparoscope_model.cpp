// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_model.hpp"

#include <Eigen/Geometry>

namespace trocar {
namespace {

const LaparoscopeGeometry& valid(const LaparoscopeGeometry& geometry) {
  validate(geometry);
  return geometry;
}

}  // namespace

LaparoscopeModel::LaparoscopeModel(const LaparoscopeGeometry& g)
    : geometry_(valid(g)),
      delta_(g.base_radius, g.platform_radius, g.link_length),
      rings_(g.ring_radius),
      tool_(g.tool_length, g.ring_plane, g.roll) {}

AssemblyStatus LaparoscopeModel::forward(const Vector6d& q,
                                         LaparoscopeConfiguration& c) const RT_SAFE {
  c.q = q;
  if (const auto s = delta_.forward(q.head<3>(), c.delta); s != AssemblyStatus::ok) return s;
  if (const auto s = rings_.forward(q.tail<3>(), c.rings); s != AssemblyStatus::ok) return s;
  return tool_.forward(c.delta.platform, c.rings.centre, c.rings.theta, c.rings.heading, c.tool);
}

AssemblyStatus LaparoscopeModel::inverse(const PoseCoordinates& pose, Vector6d& q) const RT_SAFE {
  Tool::State tool;
  if (const auto s = tool_.inverse(pose, tool); s != AssemblyStatus::ok) return s;
  return actuators(tool, q);
}

AssemblyStatus LaparoscopeModel::inverse(const Eigen::Vector3d& tip,
                                         const Eigen::Matrix3d& rotation, double theta_near,
                                         Vector6d& q) const RT_SAFE {
  Tool::State tool;
  if (const auto s = tool_.inverse(tip, rotation, theta_near, tool); s != AssemblyStatus::ok)
    return s;
  return actuators(tool, q);
}

AssemblyStatus LaparoscopeModel::actuators(const Tool::State& tool, Vector6d& q) const RT_SAFE {
  Eigen::Vector3d sliders, rings;
  if (const auto s = delta_.inverse(tool.ball, sliders); s != AssemblyStatus::ok) return s;
  if (const auto s = rings_.inverse(tool.gimbal.head<2>(), tool.theta, rings);
      s != AssemblyStatus::ok)
    return s;
  q << sliders, rings;
  return AssemblyStatus::ok;
}

LaparoscopeRates LaparoscopeModel::rates(const LaparoscopeConfiguration& c) const RT_SAFE {
  LaparoscopeRates r;
  r.delta = delta_.rates(c.delta);
  r.rings = rings_.jacobian(c.rings);
  r.tool = tool_.rates(c.tool);
  const double l = tool_.length();
  const Eigen::Matrix3d axis_from_delta = r.tool.axis * r.delta.jacobian;
  r.jacobian.topLeftCorner<3, 3>() = r.delta.jacobian - l * axis_from_delta;
  r.jacobian.topRightCorner<3, 3>() = l * (r.tool.axis.leftCols<2>() * r.rings.topRows<2>());
  r.jacobian.bottomLeftCorner<3, 3>() = -(r.tool.swing * r.delta.jacobian);
  r.jacobian.bottomRightCorner<3, 3>() =
      r.tool.swing.leftCols<2>() * r.rings.topRows<2>() + r.tool.roll * r.rings.row(2);
  return r;
}

Vector6d static_effort(const LaparoscopeRates& rates, const Vector6d& wrench) RT_SAFE {
  return rates.jacobian.transpose() * wrench;
}

Eigen::Vector3d point_on_tool(const Tool::State& tool, double s) RT_SAFE {
  return tool.tip + s * tool.axis;
}

Vector6d wrench_at_tip(const Tool::State& tool, const Eigen::Vector3d& point,
                       const Vector6d& wrench) RT_SAFE {
  Vector6d shifted = wrench;
  shifted.tail<3>() += (point - tool.tip).cross(wrench.head<3>());
  return shifted;
}

Eigen::Vector3d velocity_at(const Tool::State& tool, const Eigen::Vector3d& point,
                            const Vector6d& twist) RT_SAFE {
  return twist.head<3>() + twist.tail<3>().cross(point - tool.tip);
}

}  // namespace trocar
