// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPainter>
#include <optional>
#include <vector>

#include "gui/device/camera.hpp"
#include "gui/device/mechanism_picture.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// Paints a picture as a camera sees it, far things first: what is nearer covers what is behind it.
class MechanismPaint {
 public:
  /// @param mount upright <- N, @param stale what is painted is of the past
  MechanismPaint(QPainter& painter, const Camera& camera, const Eigen::Quaterniond& mount,
                 const Theme& theme, bool stale)
      : painter_(painter), camera_(camera), mount_(mount), theme_(theme), stale_(stale) {}

  void paint(const MechanismPicture& picture);
  /// N's axes, with its origin at `corner`.
  void paint_triad(const QPointF& corner, double length);
  /// A round length in mm, at most `longest` pixels; its left end at `left`.
  void paint_scale_bar(const QPointF& left, double longest);

 private:
  struct Piece;
  using Part = MechanismPicture::Part;

  Eigen::Vector3d upright(const Eigen::Vector3d& point) const { return mount_ * point; }
  std::vector<Piece> pieces_of(const MechanismPicture& picture) const;
  void paint_piece(const Piece& piece);
  void paint_dot(const QPointF& at, Part part);
  void paint_labels(const MechanismPicture& picture);
  std::optional<QRectF> free_place(const QPointF& at, const QSizeF& size,
                                   const std::vector<QRectF>& taken) const;
  void paint_text(const QPointF& baseline, const QString& text, const QColor& colour);
  QPen pen_of(Part part) const;

  QPainter& painter_;
  const Camera& camera_;
  Eigen::Quaterniond mount_;
  const Theme& theme_;
  bool stale_;
};

}  // namespace trocar::gui
