// SPDX-License-Identifier: Apache-2.0
#include "gui/device/mechanism_paint.hpp"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace trocar::gui {
namespace {

constexpr double in_front = 10.0;  // [m]: nothing hides a force, which often points along the tool
constexpr double longest_piece = 0.015;  // [m]: of long lines, each piece has a depth of its own

}  // namespace

/// A piece of a line, a dot or a sheet.
struct MechanismPaint::Piece {
  double depth = 0.0;  // [m]
  MechanismPicture::Part part = MechanismPicture::Part::base;
  QPolygonF points{};
};

QPen MechanismPaint::pen_of(Part part) const {
  const auto pen = [&](const QColor& colour, double width, Qt::PenStyle style = Qt::SolidLine) {
    return QPen(stale_ ? theme_.muted : colour, width, style, Qt::RoundCap, Qt::RoundJoin);
  };
  const auto curve = [&](std::size_t n) { return theme_.curve(n).color(); };
  switch (part) {
    case Part::base:
      return pen(theme_.muted, 1.2);
    case Part::rail:
      return pen(theme_.muted, 3.0);
    case Part::carriage:
    case Part::rod:
      return pen(curve(0), 2.4);
    case Part::platform:
      return pen(curve(0), 1.8);
    case Part::ring:
      return pen(curve(1), 2.4);
    case Part::spoke:
    case Part::gimbal:
      return pen(curve(1), 1.6);
    case Part::tool:
      return pen(theme_.text, 4.0);
    case Part::site:
      return pen(theme_.text, 1.6);
    case Part::wall:
      return pen(curve(2), 1.0);
    case Part::spring:
      return pen(curve(3), 1.6);
    case Part::force:
      return pen(theme_.danger, 2.6);
    case Part::workspace:
      return pen(theme_.muted, 0.8, Qt::DotLine);
    case Part::point:
      return pen(theme_.accent, 1.6);
  }
  return pen(theme_.text, 1.0);
}

std::vector<MechanismPaint::Piece> MechanismPaint::pieces_of(
    const MechanismPicture& picture) const {
  std::vector<Piece> pieces;
  for (const MechanismPicture::Line& line : picture.lines) {
    const Eigen::Vector3d from = upright(line.from), way = upright(line.to) - from;
    // Dotted lines would begin anew at each piece.
    const bool whole = line.part == Part::workspace;
    const int count = whole ? 1 : std::max(1, static_cast<int>(way.norm() / longest_piece));
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d a = from + way * (static_cast<double>(i) / count);
      const Eigen::Vector3d b = from + way * ((i + 1.0) / count);
      const double front = line.part == Part::force ? in_front : 0.0;
      pieces.push_back({camera_.depth(0.5 * (a + b)) + front, line.part,
                        QPolygonF({camera_.project(a), camera_.project(b)})});
    }
  }
  for (const MechanismPicture::Dot& dot : picture.dots)  // in front of the lines that end there
    pieces.push_back({camera_.depth(upright(dot.at)) + longest_piece, dot.part,
                      QPolygonF({camera_.project(upright(dot.at))})});
  for (const MechanismPicture::Sheet& sheet : picture.sheets) {
    Piece piece{0.0, sheet.part, {}};
    for (const Eigen::Vector3d& corner : sheet.corners) {
      piece.points << camera_.project(upright(corner));
      piece.depth += camera_.depth(upright(corner)) / static_cast<double>(sheet.corners.size());
    }
    pieces.push_back(std::move(piece));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.depth < b.depth; });
  return pieces;
}

void MechanismPaint::paint(const MechanismPicture& picture) {
  painter_.setRenderHint(QPainter::Antialiasing);
  for (const Piece& piece : pieces_of(picture)) paint_piece(piece);
  paint_labels(picture);
}

void MechanismPaint::paint_piece(const Piece& piece) {
  const QPen pen = pen_of(piece.part);
  painter_.setBrush(Qt::NoBrush);
  if (piece.points.size() == 1) {
    paint_dot(piece.points.front(), piece.part);
  } else if (piece.points.size() == 2) {
    if (pen.widthF() > 1.0) {  // an edge in the ground's colour tells what passes in front
      painter_.setPen(QPen(theme_.surface, pen.widthF() + 3.0, Qt::SolidLine, Qt::FlatCap));
      painter_.drawPolyline(piece.points);
    }
    painter_.setPen(pen);
    painter_.drawPolyline(piece.points);
  } else {
    QColor fill = pen.color();
    fill.setAlphaF(0.16F);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(fill);
    painter_.drawPolygon(piece.points);
  }
}

void MechanismPaint::paint_dot(const QPointF& at, Part part) {
  const QPen pen = pen_of(part);
  painter_.setPen(QPen(theme_.surface, 1.0));
  painter_.setBrush(pen.color());
  switch (part) {
    case Part::carriage:
      painter_.drawRect(QRectF(at.x() - 6, at.y() - 4, 12, 8));
      break;
    case Part::gimbal:
      painter_.setPen(QPen(pen.color(), 2.0));
      painter_.setBrush(theme_.surface);
      painter_.drawEllipse(at, 6, 6);
      break;
    case Part::site:
      painter_.setPen(QPen(pen.color(), 2.0));
      painter_.setBrush(theme_.surface);
      painter_.drawEllipse(at, 4, 4);
      break;
    default:
      painter_.drawEllipse(at, 4, 4);
  }
}

void MechanismPaint::paint_text(const QPointF& baseline, const QString& text,
                                const QColor& colour) {
  QPainterPath path;
  path.addText(baseline, painter_.font(), text);
  painter_.strokePath(path, QPen(theme_.surface, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter_.fillPath(path, colour);
}

/// Beside its point, where no other text is yet: the most telling first, joints' numbers last.
void MechanismPaint::paint_labels(const MechanismPicture& picture) {
  const auto rank = [](Part part) {
    return part == Part::force                            ? 0
           : part == Part::site || part == Part::point    ? 1
           : part == Part::carriage || part == Part::ring ? 3
                                                          : 2;
  };
  std::vector<const MechanismPicture::Label*> labels;
  for (const MechanismPicture::Label& label : picture.labels) labels.push_back(&label);
  std::stable_sort(labels.begin(), labels.end(),
                   [&](const auto* a, const auto* b) { return rank(a->part) < rank(b->part); });
  const QFontMetricsF metrics(painter_.font());
  std::vector<QRectF> taken;
  for (const MechanismPicture::Label* label : labels) {
    const QSizeF size(metrics.horizontalAdvance(label->text), metrics.height());
    const auto box = free_place(camera_.project(upright(label->at)), size, taken);
    if (!box) continue;
    taken.push_back(*box);
    const QColor colour = label->part == Part::force ? pen_of(Part::force).color()
                          : stale_                   ? theme_.muted
                                                     : theme_.text;
    paint_text(box->topLeft() + QPointF(0, metrics.ascent()), label->text, colour);
  }
}

std::optional<QRectF> MechanismPaint::free_place(const QPointF& at, const QSizeF& size,
                                                 const std::vector<QRectF>& taken) const {
  const QRectF sheet = painter_.viewport();
  for (const double far : {9.0, 26.0}) {
    const QPointF places[] = {{far, -0.5 * size.height()},
                              {-far - size.width(), -0.5 * size.height()},
                              {-0.5 * size.width(), -size.height() - far},
                              {-0.5 * size.width(), far},
                              {far, -1.3 * size.height()},
                              {far, 0.3 * size.height()}};
    for (const QPointF& place : places) {
      const QRectF box(at + place, size);
      const bool free = std::none_of(taken.begin(), taken.end(),
                                     [&](const QRectF& other) { return other.intersects(box); });
      if (free && sheet.contains(box)) return box;
    }
  }
  return std::nullopt;
}

void MechanismPaint::paint_triad(const QPointF& corner, double length) {
  const char* names[] = {"x", "y", "z"};
  const QPointF origin = camera_.project(Eigen::Vector3d::Zero());
  painter_.setPen(QPen(theme_.text, 1.6));
  for (int i = 0; i < 3; ++i) {
    const QPointF seen = camera_.project(upright(Eigen::Vector3d::Unit(i))) - origin;
    const QPointF end = corner + seen * (length / camera_.pixels_per_metre());
    painter_.setPen(QPen(theme_.text, 1.6));
    painter_.drawLine(corner, end);
    const QPointF beyond = corner + (end - corner) * 1.3;
    paint_text(beyond + QPointF(-4, 4), names[i], theme_.text);
  }
}

void MechanismPaint::paint_scale_bar(const QPointF& left, double longest) {
  const double room = 1e3 * longest / camera_.pixels_per_metre();  // [mm]
  const double decade = std::pow(10.0, std::floor(std::log10(room)));
  const double length = decade * (room >= 5.0 * decade ? 5.0 : room >= 2.0 * decade ? 2.0 : 1.0);
  const double pixels = 1e-3 * length * camera_.pixels_per_metre();
  painter_.setPen(QPen(theme_.text, 1.6));
  painter_.drawLine(left, left + QPointF(pixels, 0));
  for (const double x : {0.0, pixels})
    painter_.drawLine(left + QPointF(x, -4), left + QPointF(x, 4));
  paint_text(left + QPointF(0, -7), QString("%1 mm").arg(length), theme_.text);
}

}  // namespace trocar::gui
