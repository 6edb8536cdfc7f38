// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_gravity.hpp"

namespace trocar {

using Eigen::Vector2d;
using Eigen::Vector3d;

LaparoscopeGravity::LaparoscopeGravity(const LaparoscopeGeometry& geometry,
                                       const LaparoscopeMasses& masses)
    : m_(masses), ring_plane_(geometry.ring_plane) {
  validate(masses);
}

Vector6d LaparoscopeGravity::effort(const LaparoscopeConfiguration& c, const LaparoscopeRates& r,
                                    const Vector3d& g) const RT_SAFE {
  const Vector3d tool = m_.tool * g;
  const Vector3d swung = m_.tool_centre * (r.tool.axis * tool);
  const Vector3d at_ball = (m_.platform + 1.5 * m_.link_pair) * g + tool - swung;
  const Vector2d at_gimbal = (swung + m_.end_effector * g).head<2>();
  const double at_sliders = (m_.slider + 0.5 * m_.link_pair) * g.z();
  Vector6d tau;
  tau.head<3>() = -(r.delta.jacobian.transpose() * at_ball).array() - at_sliders;
  tau.tail<3>() = -r.rings.topRows<2>().transpose() * at_gimbal -
                  m_.pin * (c.rings.pins.transpose() * Vector2d(g.y(), -g.x()));
  return tau;
}

double LaparoscopeGravity::potential(const LaparoscopeConfiguration& c,
                                     const Vector3d& g) const RT_SAFE {
  const Vector3d com = c.tool.ball + m_.tool_centre * c.tool.axis;
  const Vector2d pins = c.rings.pins.rowwise().sum();
  Vector3d moment = (m_.platform + 1.5 * m_.link_pair) * c.tool.ball + m_.tool * com +
                    m_.end_effector * c.tool.gimbal +
                    m_.pin * Vector3d(pins.x(), pins.y(), 3.0 * ring_plane_);
  // The three rails stand around the origin: only the sliders' heights are left.
  moment.z() += (m_.slider + 0.5 * m_.link_pair) * c.q.head<3>().sum();
  return -g.dot(moment);
}

}  // namespace trocar
