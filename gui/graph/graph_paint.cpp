// SPDX-License-Identifier: Apache-2.0
#include "gui/graph/graph_paint.hpp"

#include <QPainterPath>

#include "gui/data/shown_number.hpp"

namespace trocar::gui {
namespace {

using GraphLine = GraphStructure::Line;

/// Across gaps between columns it bends; past a column and back it is straight.
QPainterPath path_of(const GraphLayout::Route& route) {
  QPainterPath path(route.points.front());
  for (qsizetype i = 1; i < route.points.size(); ++i) {
    const QPointF from = route.points[i - 1], to = route.points[i];
    const QPointF half(0.5 * (to.x() - from.x()), 0.0);
    if (route.back || from.y() == to.y())
      path.lineTo(to);
    else
      path.cubicTo(from + half, to - half, to);
  }
  return path;
}

QColor colour_of(const GraphModel::NodeLive& live, const Theme& theme) {
  switch (live.state) {
    case GraphModel::State::running:
      return theme.ok;
    case GraphModel::State::faulted:
      return theme.danger;
    default:
      return theme.muted;
  }
}

void paint_frame(QPainter& painter, const GraphLayout::Frame& frame, const Theme& theme) {
  painter.setPen(QPen(theme.grid, frame.is_thread ? 1.5 : 1.0,
                      frame.is_thread ? Qt::DashLine : Qt::SolidLine));
  QColor ground = theme.window;
  ground.setAlphaF(frame.is_thread ? 0.4F : 0.8F);
  painter.setBrush(ground);
  painter.drawRoundedRect(frame.rect, 6, 6);
  painter.setPen(theme.muted);
  painter.drawText(frame.rect.adjusted(8, 2, -8, 0), Qt::AlignLeft | Qt::AlignTop, frame.title);
}

void paint_arrow(QPainter& painter, const GraphLayout::Route& route, const QPen& pen) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen);
  painter.drawPath(path_of(route));
  const QPointF tip = route.points.back();
  painter.setPen(Qt::NoPen);
  painter.setBrush(pen.color());
  painter.drawPolygon(QPolygonF({tip, tip + QPointF(-9, -4), tip + QPointF(-9, 4)}));
}

void paint_edge(QPainter& painter, const GraphModel& model, std::size_t index, const Theme& theme,
                bool chosen) {
  const GraphStructure::Edge& edge = model.structure().edges[index];
  const GraphModel::EdgeLive& live = model.edge(index);
  const bool lost = live.known && !live.valid;
  QPen pen(lost ? theme.danger : chosen ? theme.accent : theme.muted, chosen ? 2.4 : 1.3);
  if (edge.line == GraphLine::later_tick) pen.setStyle(Qt::DotLine);
  if (edge.line == GraphLine::other_thread) pen.setStyle(Qt::DashLine);
  const GraphLayout::Route& route = model.layout().routes[index];
  paint_arrow(painter, route, pen);
  if (!live.known) return;
  const QString text = (lost ? "LOST " : "") + shown_number(live.age, "s");
  painter.setPen(lost ? theme.danger : theme.text);
  painter.drawText(route.points[route.points.size() - 2] + QPointF(6, -4), text);
}

void paint_node(QPainter& painter, const GraphModel& model, std::size_t index, const Theme& theme,
                bool chosen) {
  const GraphStructure::Node& node = model.structure().nodes[index];
  const GraphModel::NodeLive& live = model.node(index);
  const QRectF box = model.layout().boxes[index];
  const QColor state = colour_of(live, theme);
  painter.setBrush(theme.surface);
  painter.setPen(QPen(chosen        ? theme.accent
                      : node.device ? theme.text
                                    : theme.muted,
                      chosen ? 3.0 : 1.2));
  painter.drawRoundedRect(box, 5, 5);
  if (node.device) painter.drawRoundedRect(box.adjusted(3, 3, -3, -3), 3, 3);

  const QFontMetricsF metrics(painter.font());
  const QRectF inner = box.adjusted(10, 5, -10, -5);
  const double line = inner.height() / 3.0;
  const auto write = [&](int n, const QString& text, const QColor& colour, bool bold) {
    QFont font = painter.font();
    font.setBold(bold);
    painter.setFont(font);
    painter.setPen(colour);
    const QRectF at(inner.left(), inner.top() + n * line, inner.width(), line);
    painter.drawText(at, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(font).elidedText(text, Qt::ElideRight, at.width()));
    font.setBold(false);
    painter.setFont(font);
  };
  write(0, model.structure().title(index), theme.text, true);
  write(1, QString::fromStdString(node.type), theme.muted, false);
  const bool fault = live.state == GraphModel::State::faulted;
  const QString timing = model.timing_text(index);
  write(2, fault || timing.isEmpty() ? model.state_text(index) : timing,
        fault ? theme.danger : theme.text, fault);
  painter.setPen(Qt::NoPen);
  painter.setBrush(state);
  const QRectF lamp(inner.right() - 8, inner.top() + 3, 10, 10);
  if (fault)
    painter.drawPolygon(
        QPolygonF({QPointF(lamp.center().x(), lamp.top()), lamp.bottomRight(), lamp.bottomLeft()}));
  else if (live.state == GraphModel::State::running)
    painter.drawEllipse(lamp);
  else
    painter.drawRect(lamp.adjusted(1, 4, -1, -4));
}

}  // namespace

void paint_graph(QPainter& painter, const GraphModel& model, const Theme& theme,
                 std::optional<std::size_t> selected) {
  QFont font = painter.font();
  font.setPixelSize(13);  // of the layout, whose boxes do not grow with the font
  painter.setFont(font);
  for (const GraphLayout::Frame& frame : model.layout().frames) paint_frame(painter, frame, theme);
  const auto touches = [&](std::size_t i) {
    const GraphStructure::Edge& edge = model.structure().edges[i];
    return selected && (edge.from == *selected || edge.to == *selected);
  };
  for (const bool chosen : {false, true})
    for (std::size_t i = 0; i < model.structure().edges.size(); ++i)
      if (touches(i) == chosen) paint_edge(painter, model, i, theme, chosen);
  for (std::size_t i = 0; i < model.structure().nodes.size(); ++i)
    paint_node(painter, model, i, theme, selected == i);
}

}  // namespace trocar::gui
