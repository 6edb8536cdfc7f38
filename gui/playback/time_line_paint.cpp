// SPDX-License-Identifier: Apache-2.0
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "gui/playback/time_line.hpp"
#include "gui/plots/round_step.hpp"

namespace trocar::gui {
namespace {

constexpr double side = 12.0, top = 14.0, thick = 10.0;  // of the bar [px]

}  // namespace

double TimeLine::x_of(double time) const {
  const LogFeed::Span whole = feed_.whole();
  const double length = std::max(whole.to - whole.from, 1e-9);
  return side + (width() - 2.0 * side) * std::clamp((time - whole.from) / length, 0.0, 1.0);
}

double TimeLine::time_at(double x) const {
  const LogFeed::Span whole = feed_.whole();
  const double share = std::clamp((x - side) / std::max(1.0, width() - 2.0 * side), 0.0, 1.0);
  return whole.from + share * (whole.to - whole.from);
}

void TimeLine::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_bar(painter);
  paint_numbers(painter);
  for (const RunEvent& event : store_.events())
    if (is_marked(event)) paint_event(painter, event);
  paint_handle(painter);
}

void TimeLine::paint_bar(QPainter& painter) const {
  painter.setPen(QPen(theme_.muted, 1.0));
  painter.setBrush(QBrush(theme_.muted, Qt::BDiagPattern));  // hatched: not loaded
  painter.drawRect(QRectF(side, top, width() - 2.0 * side, thick));
  const LogFeed::Span loaded = feed_.loaded();
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_.grid);
  if (loaded.to > loaded.from)
    painter.drawRect(QRectF(x_of(loaded.from), top, x_of(loaded.to) - x_of(loaded.from), thick));
  painter.setBrush(theme_.accent);
  const double begin = x_of(std::max(loaded.from, feed_.whole().from));
  painter.drawRect(QRectF(begin, top + 3.0, std::max(0.0, x_of(clock_.now()) - begin), 4.0));
  if (!clock_.loop()) return;
  painter.setPen(QPen(theme_.replay, 2.0));
  const double a = x_of(clock_.loop()->from), b = x_of(clock_.loop()->to);
  for (const auto& [x, inwards] : {std::pair{a, 4.0}, std::pair{b, -4.0}}) {
    painter.drawLine(QPointF(x, top - 3.0), QPointF(x, top + thick + 3.0));
    painter.drawLine(QPointF(x, top - 3.0), QPointF(x + inwards, top - 3.0));
    painter.drawLine(QPointF(x, top + thick + 3.0), QPointF(x + inwards, top + thick + 3.0));
  }
}

void TimeLine::paint_numbers(QPainter& painter) const {
  const LogFeed::Span whole = feed_.whole();
  const double length = whole.to - whole.from;
  if (!(length > 0.0)) return;
  constexpr double room = 80.0;  // [px] for a number
  const double step = round_step(length * room / std::max(1.0, width() - 2.0 * side));
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  painter.setPen(theme_.text);
  QFont small = font();
  small.setPointSizeF(0.85 * small.pointSizeF());
  painter.setFont(small);
  const double first = std::ceil(whole.from / step - 1e-9);
  for (double n = first; n * step <= whole.to * (1.0 + 1e-12); ++n) {
    const double x = x_of(n * step);
    painter.drawLine(QPointF(x, top + thick), QPointF(x, top + thick + 3.0));
    const QString text = tr("%1 s").arg(n * step, 0, 'f', digits);
    QRectF box(x, top + thick + 3.0, room, 17.0);
    const double wide = painter.fontMetrics().horizontalAdvance(text) + 4.0;
    box.setWidth(wide);
    box.moveLeft(std::clamp(x - 0.5 * wide, 0.0, std::max(0.0, width() - wide)));
    painter.drawText(box, Qt::AlignTop | Qt::AlignHCenter, text);
  }
}

void TimeLine::paint_event(QPainter& painter, const RunEvent& event) const {
  const double x = x_of(event.time);
  painter.setPen(QPen(theme_.surface, 1.0));
  QPolygonF shape;
  if (event.kind == "fault") {
    painter.setBrush(theme_.danger);
    shape = {{x - 6.0, 1.0}, {x + 6.0, 1.0}, {x, 13.0}};
  } else if (event.kind == "annotated") {
    painter.setBrush(theme_.accent);
    shape = {{x, 1.0}, {x + 5.0, 7.0}, {x, 13.0}, {x - 5.0, 7.0}};
  } else {
    painter.setBrush(theme_.warning);
    shape = {{x - 4.0, 3.0}, {x + 4.0, 3.0}, {x + 4.0, 11.0}, {x - 4.0, 11.0}};
  }
  painter.drawPolygon(shape);
}

void TimeLine::paint_handle(QPainter& painter) const {
  const double x = x_of(clock_.now());
  painter.setPen(QPen(theme_.surface, 1.5));
  painter.setBrush(theme_.accent);
  painter.drawRoundedRect(QRectF(x - 4.0, top - 4.0, 8.0, thick + 8.0), 3.0, 3.0);
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme_.text, 1.5));
  painter.drawRoundedRect(QRectF(x - 6.5, top - 6.5, 13.0, thick + 13.0), 4.0, 4.0);
}

}  // namespace trocar::gui
