// SPDX-License-Identifier: Apache-2.0
#include "gui/device/camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace trocar::gui {

void Camera::turn_by(double turn, double lift) {
  turn_ = std::remainder(turn_ + turn, 2.0 * std::numbers::pi);
  lift_ = std::clamp(lift_ + lift, -0.5 * std::numbers::pi, 0.5 * std::numbers::pi);
  axes_ = axes();
}

void Camera::zoom_by(double factor) {
  zoom_ = std::clamp(zoom_ * factor, 0.25, 20.0);
}

void Camera::reset() {
  turn_ = first_turn;
  lift_ = first_lift;
  zoom_ = 1.0;
  axes_ = axes();
}

Eigen::Matrix3d Camera::axes() const {
  const double ct = std::cos(turn_), st = std::sin(turn_);
  const double cl = std::cos(lift_), sl = std::sin(lift_);
  Eigen::Matrix3d axes;
  axes << -st, ct, 0.0,  //
      -sl * ct, -sl * st, cl, cl * ct, cl * st, sl;
  return axes;
}

void Camera::fit(const std::vector<Eigen::Vector3d>& points, const QRectF& into) {
  middle_ = into.center();
  if (points.empty()) return;
  Eigen::Vector2d low = (axes_ * points.front()).head<2>(), high = low;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector2d seen = (axes_ * point).head<2>();
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  }
  const Eigen::Vector2d size = (high - low).cwiseMax(1e-3);
  scale_ = zoom_ * std::max(1.0, std::min(into.width() / size.x(), into.height() / size.y()));
  seen_middle_ = 0.5 * (low + high);
}

QPointF Camera::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector2d seen = (axes_ * point).head<2>() - seen_middle_;
  return middle_ + QPointF(scale_ * seen.x(), -scale_ * seen.y());
}

double Camera::depth(const Eigen::Vector3d& point) const {
  return axes_.row(2).dot(point);
}

}  // namespace trocar::gui
