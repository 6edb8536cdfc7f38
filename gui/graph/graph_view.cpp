// SPDX-License-Identifier: Apache-2.0
#include "gui/graph/graph_view.hpp"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "gui/graph/graph_paint.hpp"

namespace trocar::gui {
namespace {

constexpr double graph_zoom_step = 1.25;
constexpr double most_zoom = 3.0, least_zoom = 0.1;

}  // namespace

GraphView::GraphView(GraphModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  setObjectName("graph");
  setAccessibleName("components and wires");
  setToolTip(
      "A click or the arrow keys choose a component, the wheel or + and − zoom, dragging moves, "
      "Home fits all in");
  setFocusPolicy(Qt::StrongFocus);
  connect(&model_, &GraphModel::structure_changed, this, &GraphView::take_structure);
  take_structure();
}

void GraphView::take_structure() {
  selected_.reset();
  if (!model_.structure().nodes.empty()) selected_ = 0;
  fit();
  Q_EMIT selected_changed();
}

void GraphView::set_theme(const Theme& theme) {
  theme_ = theme;
  update();
}

void GraphView::select(std::optional<std::size_t> node) {
  if (node == selected_) return;
  selected_ = node;
  setAccessibleDescription(node ? model_.description(*node) : QString());
  if (node && !fitted_ && !QRectF(rect()).contains(box_of(*node))) {
    const QPointF way = QRectF(rect()).center() - box_of(*node).center();
    to_widget_ *= QTransform::fromTranslate(way.x(), way.y());
    fitted_ = false;
  }
  Q_EMIT selected_changed();
  update();
}

void GraphView::fit() {
  const QRectF all = model_.layout().bounds.adjusted(-16, -16, 16, 16);
  const double scale =
      std::clamp(std::min(width() / all.width(), height() / all.height()), least_zoom, 1.25);
  to_widget_ = QTransform::fromTranslate(-all.center().x(), -all.center().y()) *
               QTransform::fromScale(scale, scale) *
               QTransform::fromTranslate(0.5 * width(), 0.5 * height());
  fitted_ = true;
  update();
}

QRectF GraphView::box_of(std::size_t node) const {
  return to_widget_.mapRect(model_.layout().boxes[node]);
}

void GraphView::zoom_at(const QPointF& point, double factor) {
  factor = std::clamp(factor, least_zoom / scale(), most_zoom / scale());
  to_widget_ *= QTransform::fromTranslate(-point.x(), -point.y()) *
                QTransform::fromScale(factor, factor) *
                QTransform::fromTranslate(point.x(), point.y());
  fitted_ = false;
  update();
}

std::optional<std::size_t> GraphView::node_at(const QPointF& point) const {
  for (std::size_t node = 0; node < model_.layout().boxes.size(); ++node)
    if (box_of(node).contains(point)) return node;
  return std::nullopt;
}

/// To the nearest box in that direction; what lies aside counts as farther.
void GraphView::go(int dx, int dy) {
  const std::vector<QRectF>& boxes = model_.layout().boxes;
  if (boxes.empty()) return;
  if (!selected_) return select(0);
  const QPointF from = boxes[*selected_].center();
  std::optional<std::size_t> best;
  double best_cost = 0.0;
  for (std::size_t node = 0; node < boxes.size(); ++node) {
    const QPointF way = boxes[node].center() - from;
    const double along = dx * way.x() + dy * way.y();
    const double aside = std::abs(dx != 0 ? way.y() : way.x());
    if (!(along > 1.0)) continue;
    const double cost = along + 2.0 * aside;
    if (best && cost >= best_cost) continue;
    best = node;
    best_cost = cost;
  }
  if (best) select(best);
}

void GraphView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.surface);
  painter.setRenderHint(QPainter::Antialiasing);
  if (model_.structure().nodes.empty()) {
    painter.setPen(theme_.muted);
    painter.drawText(rect(), Qt::AlignCenter, "the graph is not known yet");
  } else {
    painter.save();
    painter.setTransform(to_widget_, true);
    paint_graph(painter, model_, theme_, selected_);
    painter.restore();
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(hasFocus() ? theme_.accent : theme_.grid, hasFocus() ? 2.0 : 1.0));
  painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
}

void GraphView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (fitted_) fit();
}

void GraphView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return go(-1, 0);
    case Qt::Key_Right:
      return go(1, 0);
    case Qt::Key_Up:
      return go(0, -1);
    case Qt::Key_Down:
      return go(0, 1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom_at(rect().center(), graph_zoom_step);
    case Qt::Key_Minus:
      return zoom_at(rect().center(), 1.0 / graph_zoom_step);
    case Qt::Key_Home:
      return fit();
    default:
      QWidget::keyPressEvent(event);
  }
}

void GraphView::mousePressEvent(QMouseEvent* event) {
  dragged_from_ = event->position();
  if (const auto node = node_at(event->position())) select(node);
}

void GraphView::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) == 0) return;
  const QPointF way = event->position() - dragged_from_;
  dragged_from_ = event->position();
  to_widget_ *= QTransform::fromTranslate(way.x(), way.y());
  fitted_ = false;
  update();
}

void GraphView::wheelEvent(QWheelEvent* event) {
  zoom_at(event->position(), std::exp(event->angleDelta().y() / 600.0));
}

}  // namespace trocar::gui
