// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/tool_roll.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace trocar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d outer_axis(RollModel model, const RingDirection& ring) RT_SAFE {
  if (model == RollModel::gimbal_outer_x) return {ring.x(), ring.y(), 0.0};
  return {-ring.y(), ring.x(), 0.0};
}

/// The smallest rotation that takes n3 to t.
Matrix3d swing(const Vector3d& t) RT_SAFE {
  const double s = 1.0 / (1.0 + t.z());
  Matrix3d r;
  r << 1.0 - s * t.x() * t.x(), -s * t.x() * t.y(), t.x(),  //
      -s * t.x() * t.y(), 1.0 - s * t.y() * t.y(), t.y(),   //
      -t.x(), -t.y(), t.z();
  return r;
}

Matrix3d columns(const Vector3d& x, const Vector3d& y, const Vector3d& z) RT_SAFE {
  Matrix3d r;
  r.col(0) = x;
  r.col(1) = y;
  r.col(2) = z;
  return r;
}

}  // namespace

Matrix3d tool_rotation(RollModel model, const Vector3d& axis, const RingDirection& ring) RT_SAFE {
  if (model == RollModel::zero_torsion) {
    const Matrix3d s = swing(axis);
    return columns(ring.x() * s.col(0) + ring.y() * s.col(1),
                   ring.x() * s.col(1) - ring.y() * s.col(0), axis);
  }
  const Vector3d inner = outer_axis(model, ring).cross(axis).normalized();
  const Vector3d third = axis.cross(inner);
  return model == RollModel::gimbal_outer_y ? columns(inner, third, axis)
                                            : columns(third, -inner, axis);
}

double ring_angle(RollModel model, const Matrix3d& r) RT_SAFE {
  if (model == RollModel::gimbal_outer_y) return std::atan2(r(1, 0), r(0, 0));
  if (model == RollModel::gimbal_outer_x) return std::atan2(-r(0, 1), r(1, 1));
  const Matrix3d s = swing(r.col(2));
  return std::atan2(s.col(1).dot(r.col(0)), s.col(0).dot(r.col(0)));
}

RollRate roll_rate(RollModel model, const Vector3d& axis, const RingDirection& ring) RT_SAFE {
  if (model == RollModel::zero_torsion) return {1.0, Vector3d(0.0, 0.0, -1.0 / (1.0 + axis.z()))};
  const Vector3d outer = outer_axis(model, ring);
  const double u = outer.dot(axis);
  const double scale = 1.0 / (1.0 - u * u);
  return {axis.z() * scale, u * scale * outer};
}

RollRate roll_rate_derivative(RollModel model, const Vector3d& axis, const RingDirection& ring,
                              const Vector3d& axis_rate, double ring_rate) RT_SAFE {
  if (model == RollModel::zero_torsion) {
    const double s = 1.0 / (1.0 + axis.z());
    return {0.0, Vector3d(0.0, 0.0, s * s * axis_rate.z())};
  }
  const Vector3d outer = outer_axis(model, ring);
  const Vector3d outer_rate(-ring_rate * outer.y(), ring_rate * outer.x(), 0.0);
  const double u = outer.dot(axis);
  const double u_rate = outer_rate.dot(axis) + outer.dot(axis_rate);
  const double scale = 1.0 / (1.0 - u * u);
  const double scale_rate = 2.0 * u * u_rate * scale * scale;
  return {axis_rate.z() * scale + axis.z() * scale_rate,
          (u_rate * scale + u * scale_rate) * outer + u * scale * outer_rate};
}

}  // namespace trocar
