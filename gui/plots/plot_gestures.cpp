// SPDX-License-Identifier: Apache-2.0
#include "gui/plots/plot_gestures.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace trocar::gui {
namespace {

constexpr double near = 6.0;           // [px] of a cursor
constexpr double key_share = 0.05;     // of the span, for a key
constexpr double fine_share = 0.0025;  // for a cursor
constexpr double key_zoom = 1.25;

}  // namespace

PlotGestures::PlotGestures(QCustomPlot& plot) : QObject(&plot), plot_(plot) {
  plot_.setFocusPolicy(Qt::StrongFocus);
  plot_.installEventFilter(this);
}

void PlotGestures::press(const QPointF& at) {
  Q_EMIT touched();
  held_ = at;
  cursor_ = -1;
  if (!cursors_) return;
  const auto distance = [&](std::size_t i) {
    return std::abs(plot_.xAxis->coordToPixel((*cursors_)[i]) - at.x());
  };
  const std::size_t nearest = distance(0) <= distance(1) ? 0 : 1;
  if (distance(nearest) <= near) cursor_ = static_cast<int>(nearest);
}

void PlotGestures::move(const QPointF& at) {
  const double from = time_at(held_->x()), to = time_at(at.x());
  held_ = at;
  if (cursor_ >= 0) {
    const QCPRange range = plot_.xAxis->range();
    Q_EMIT cursor_moved(cursor_, std::clamp(to, range.lower, range.upper));
  } else if (from != to) {
    Q_EMIT scrubbed(from - to);
  }
}

bool PlotGestures::press_key(const QKeyEvent& key) {
  const double span = plot_.xAxis->range().size();
  if (key.key() == Qt::Key_Plus || key.key() == Qt::Key_Minus) {
    Q_EMIT zoomed(key.key() == Qt::Key_Plus ? 1.0 / key_zoom : key_zoom);
    return true;
  }
  if (key.key() != Qt::Key_Left && key.key() != Qt::Key_Right) return false;
  const double direction = key.key() == Qt::Key_Left ? -1.0 : 1.0;
  const bool a = key.modifiers().testFlag(Qt::ControlModifier);
  const bool b = key.modifiers().testFlag(Qt::ShiftModifier);
  if (!a && !b) {
    Q_EMIT scrubbed(direction * key_share * span);
  } else if (cursors_) {
    const QCPRange range = plot_.xAxis->range();
    const double to = (*cursors_)[a ? 0 : 1] + direction * fine_share * span;
    Q_EMIT cursor_moved(a ? 0 : 1, std::clamp(to, range.lower, range.upper));
  }
  return true;
}

bool PlotGestures::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      if (auto* mouse = static_cast<QMouseEvent*>(event); mouse->button() == Qt::LeftButton)
        press(mouse->position());
      return false;
    case QEvent::MouseMove:
      if (held_) move(static_cast<QMouseEvent*>(event)->position());
      return false;
    case QEvent::MouseButtonRelease:
      held_.reset();
      return false;
    case QEvent::Wheel: {
      const int steps = static_cast<QWheelEvent*>(event)->angleDelta().y();
      if (steps != 0) Q_EMIT zoomed(std::pow(key_zoom, -steps / 120.0));
      return true;  // and no page is scrolled beneath it
    }
    case QEvent::FocusIn:
      Q_EMIT touched();
      return false;
    case QEvent::KeyPress:
      return press_key(*static_cast<QKeyEvent*>(event));
    default:
      return false;
  }
}

}  // namespace trocar::gui
