// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/tool.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace trocar {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

PoseCoordinates Tool::State::pose() const RT_SAFE {
  const Vector3d d = gimbal - ball;
  return {tip, std::atan2(d.x(), d.z()), std::atan2(d.y(), d.z()), theta};
}

Vector6d Tool::State::coordinates() const RT_SAFE {
  return (Vector6d() << ball.x(), ball.y(), -ball.z(), gimbal.x(), gimbal.y(), theta).finished();
}

double Tool::State::tilt() const RT_SAFE {
  return std::atan2(std::hypot(axis.x(), axis.y()), axis.z());
}

AssemblyStatus Tool::forward(const Vector3d& ball, const Vector2d& centre, double theta,
                             const RingDirection& ring, State& s) const RT_SAFE {
  s.ball = ball;
  s.gimbal = {centre.x(), centre.y(), zt_};
  const Vector3d d = s.gimbal - ball;
  if (!(d.z() > 0.0)) return AssemblyStatus::tool_points_backwards;
  s.engagement = d.norm();
  s.axis = d / s.engagement;
  s.tip = ball + l_ * s.axis;
  s.theta = theta;
  s.ring = ring;
  s.rotation = tool_rotation(roll_, s.axis, ring);
  return AssemblyStatus::ok;
}

AssemblyStatus Tool::inverse(const PoseCoordinates& pose, State& state) const RT_SAFE {
  constexpr double quarter = std::numbers::pi / 2;
  if (!(std::abs(pose.alpha) < quarter && std::abs(pose.beta) < quarter))
    return AssemblyStatus::tool_points_backwards;
  return from_slopes(pose.tip, std::tan(pose.alpha), std::tan(pose.beta), pose.theta, state);
}

AssemblyStatus Tool::inverse(const Vector3d& tip, const Matrix3d& rotation, double theta_near,
                             State& state) const RT_SAFE {
  if (!(rotation(2, 2) > 0.0)) return AssemblyStatus::tool_points_backwards;
  constexpr double turn = 2.0 * std::numbers::pi;
  const double theta = ring_angle(roll_, rotation);
  return from_slopes(tip, rotation(0, 2) / rotation(2, 2), rotation(1, 2) / rotation(2, 2),
                     theta + turn * std::round((theta_near - theta) / turn), state);
}

AssemblyStatus Tool::from_slopes(const Vector3d& tip, double slope_x, double slope_y, double theta,
                                 State& state) const RT_SAFE {
  const Vector3d direction(slope_x, slope_y, 1.0);
  const Vector3d ball = tip - l_ / direction.norm() * direction;
  const Vector2d centre = tip.head<2>() + (zt_ - tip.z()) * direction.head<2>();
  if (!ball.allFinite() || !centre.allFinite() || !std::isfinite(theta))
    return AssemblyStatus::not_finite;
  return forward(ball, centre, theta, {std::cos(theta), std::sin(theta)}, state);
}

Tool::Rates Tool::rates(const State& s) const RT_SAFE {
  const double inverse_span = 1.0 / s.engagement;
  const Vector3d& t = s.axis;
  const RollRate roll = roll_rate(roll_, t, s.ring);
  Rates r;
  r.axis = inverse_span * (Matrix3d::Identity() - t * t.transpose());
  Matrix3d cross;
  cross << 0.0, -t.z(), t.y(), t.z(), 0.0, -t.x(), -t.y(), t.x(), 0.0;
  r.swing = inverse_span * (cross + t * roll.lever.cross(t).transpose());
  r.roll = roll.gain * t;
  return r;
}

Tool::Drift Tool::drift(const State& s, const Vector3d& span_rate, double ring_rate,
                        const Vector3d& span_drift, double ring_drift) const RT_SAFE {
  const Vector3d& t = s.axis;
  const double inverse_span = 1.0 / s.engagement;
  const double stretch = t.dot(span_rate);  // M'
  const Vector3d axis_rate = inverse_span * (span_rate - stretch * t);
  const double stretch_drift = t.dot(span_drift) + axis_rate.dot(span_rate);  // M''
  Drift drift;
  drift.axis = inverse_span * (span_drift - stretch_drift * t - 2.0 * stretch * axis_rate);

  const RollRate roll = roll_rate(roll_, t, s.ring);
  const RollRate change = roll_rate_derivative(roll_, t, s.ring, axis_rate, ring_rate);
  const Vector3d turn = t.cross(axis_rate);
  const Vector3d turn_drift = t.cross(drift.axis);
  const double kappa = roll.gain * ring_rate + roll.lever.dot(turn);
  const double kappa_drift = change.gain * ring_rate + roll.gain * ring_drift +
                             change.lever.dot(turn) + roll.lever.dot(turn_drift);
  drift.angular = turn_drift + kappa_drift * t + kappa * axis_rate;
  return drift;
}

Matrix6d Tool::jacobian(const State& state) const RT_SAFE {
  const Rates r = rates(state);
  const Vector3d mirror(1.0, 1.0, -1.0);  // vA = mirror (xd', yd', zd')
  Matrix6d j = Matrix6d::Zero();
  j.topLeftCorner<3, 3>() = (Matrix3d::Identity() - l_ * r.axis) * mirror.asDiagonal();
  j.block<3, 2>(0, 3) = l_ * r.axis.leftCols<2>();
  j.bottomLeftCorner<3, 3>() = -r.swing * mirror.asDiagonal();
  j.block<3, 2>(3, 3) = r.swing.leftCols<2>();
  j.block<3, 1>(3, 5) = r.roll;
  return j;
}

Matrix6d Tool::pose_rate_jacobian(const State& state) const RT_SAFE {
  const Vector3d d = state.gimbal - state.ball;
  const double kx = 1.0 / (d.x() * d.x() + d.z() * d.z());
  const double ky = 1.0 / (d.y() * d.y() + d.z() * d.z());
  Matrix6d j = jacobian(state);
  j.bottomRows<3>().setZero();
  j.row(3) << -d.z() * kx, 0.0, -d.x() * kx, d.z() * kx, 0.0, 0.0;
  j.row(4) << 0.0, -d.z() * ky, -d.y() * ky, 0.0, d.z() * ky, 0.0;
  j(5, 5) = 1.0;
  return j;
}

}  // namespace trocar
