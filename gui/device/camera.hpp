// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <QPointF>
#include <QRectF>
#include <vector>

namespace trocar::gui {

/// Where somebody looks from, infinitely far away: lengths across the direction of sight are true.
/// Points are upright [m], z up.
class Camera {
 public:
  static constexpr double first_turn = -0.90;  // [rad]
  static constexpr double first_lift = 0.32;   // [rad]

  /// @param turn about z, @param lift towards above [rad]; at most straight from above or below
  void turn_by(double turn, double lift);
  void zoom_by(double factor);
  void reset();
  double turn() const { return turn_; }  // [rad]
  double lift() const { return lift_; }  // [rad]
  double zoom() const { return zoom_; }

  /// Puts `points` into the rectangle, as large as they fit, times zoom().
  void fit(const std::vector<Eigen::Vector3d>& points, const QRectF& into);

  QPointF project(const Eigen::Vector3d& point) const;  // [pixels]
  double depth(const Eigen::Vector3d& point) const;     // [m] towards the eye
  double pixels_per_metre() const { return scale_; }

 private:
  /// Rows: right, up, towards the eye.
  Eigen::Matrix3d axes() const;

  double turn_ = first_turn, lift_ = first_lift, zoom_ = 1.0;
  double scale_ = 1000.0;
  Eigen::Vector2d seen_middle_ = Eigen::Vector2d::Zero();  // [m] of what is fitted, right and up
  QPointF middle_;                                         // [pixels] where that is
  Eigen::Matrix3d axes_ = axes();
};

}  // namespace trocar::gui
