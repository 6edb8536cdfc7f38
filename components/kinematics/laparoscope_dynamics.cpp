// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_dynamics.hpp"

#include <Eigen/Geometry>

namespace trocar {

using Eigen::Matrix3d;
using Eigen::Vector3d;

LaparoscopeDynamics::LaparoscopeDynamics(const LaparoscopeGeometry& geometry,
                                         const LaparoscopeMasses& masses)
    : model_(geometry), gravity_(geometry, masses), m_(masses) {}

LaparoscopeDynamics::Inertia LaparoscopeDynamics::inertia(const LaparoscopeConfiguration& c,
                                                          const LaparoscopeRates& r) const RT_SAFE {
  const double s = m_.tool_centre;
  Inertia out;
  Matrix36d& jc = out.centre_jacobian;
  jc.leftCols<3>() = r.delta.jacobian - s * (r.tool.axis * r.delta.jacobian);
  jc.rightCols<3>() = s * (r.tool.axis.leftCols<2>() * r.rings.topRows<2>());
  const Matrix36d jw = r.jacobian.bottomRows<3>();
  const Vector6d spin = jw.transpose() * c.tool.axis;

  Matrix6d& m = out.mass;
  m.noalias() = m_.tool * jc.transpose().lazyProduct(jc);
  m += m_.tool_transverse * jw.transpose().lazyProduct(jw);
  m += (m_.tool_axial - m_.tool_transverse) * spin * spin.transpose();

  // The rods' cross term m_lk/6 couples a slider with the platform's height.
  const Vector3d rod = m_.link_pair / 6.0 * r.delta.jacobian.row(2).transpose();
  const Matrix3d& jd = r.delta.jacobian;
  m.topLeftCorner<3, 3>() +=
      (m_.platform + m_.link_pair) * jd.transpose().lazyProduct(jd) +
      (rod.rowwise().replicate<3>() + rod.transpose().colwise().replicate<3>());
  m.diagonal().head<3>().array() += m_.slider + m_.link_pair / 3.0;

  const Vector3d weights(m_.end_effector, m_.end_effector, m_.end_effector_spin);
  const Matrix3d weighted = weights.asDiagonal() * r.rings;
  m.bottomRightCorner<3, 3>() += r.rings.transpose().lazyProduct(weighted);
  m.diagonal().tail<3>().array() += m_.ring;
  return out;
}

LaparoscopeDynamics::Bias LaparoscopeDynamics::bias(const LaparoscopeConfiguration& c,
                                                    const LaparoscopeRates& r,
                                                    const Inertia& inertia,
                                                    const Vector6d& v) const RT_SAFE {
  const Vector3d ball_rate = r.delta.jacobian * v.head<3>();
  const Vector3d star_rate = r.rings * v.tail<3>();
  const Vector3d ball = model_.delta().drift(r.delta, v.head<3>(), ball_rate);
  const Vector3d star = model_.rings().drift(c.rings, v.tail<3>(), star_rate);
  const Vector3d span_rate = Vector3d(star_rate.x(), star_rate.y(), 0.0) - ball_rate;
  const Vector3d span = Vector3d(star.x(), star.y(), 0.0) - ball;
  const Tool::Drift tool = model_.tool().drift(c.tool, span_rate, star_rate[2], span, star[2]);

  Bias out;
  out.twist.noalias() = r.jacobian * v;
  out.tip = ball + model_.tool().length() * tool.axis;
  out.angular = tool.angular;

  const Vector3d& t = c.tool.axis;
  const Vector3d omega = out.twist.tail<3>();
  const auto inertia_times = [&](const Vector3d& x) -> Vector3d {
    return m_.tool_transverse * x + (m_.tool_axial - m_.tool_transverse) * t.dot(x) * t;
  };
  const Vector3d moment = inertia_times(tool.angular) + omega.cross(inertia_times(omega));
  const Vector3d force = m_.tool * (ball + m_.tool_centre * tool.axis);
  out.effort.noalias() = inertia.centre_jacobian.transpose() * force;
  out.effort.noalias() += r.jacobian.bottomRows<3>().transpose() * moment;
  out.effort.head<3>() += (m_.platform + m_.link_pair) * (r.delta.jacobian.transpose() * ball);
  out.effort.head<3>().array() += m_.link_pair / 6.0 * ball.z();
  const Vector3d weights(m_.end_effector, m_.end_effector, m_.end_effector_spin);
  out.effort.tail<3>() += r.rings.transpose() * star.cwiseProduct(weights);
  return out;
}

}  // namespace trocar
