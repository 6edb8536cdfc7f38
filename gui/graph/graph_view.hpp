// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTransform>
#include <QWidget>
#include <optional>

#include "gui/graph/graph_model.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// A graph as boxes and arrows, with what goes on in it. A click or the arrow keys choose a
/// component; the wheel or + and - zoom, dragging moves, Home fits all in.
class GraphView : public QWidget {
  Q_OBJECT

 public:
  explicit GraphView(GraphModel& model, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  std::optional<std::size_t> selected() const { return selected_; }
  void select(std::optional<std::size_t> node);
  void fit();
  /// Where a component is drawn [pixels of the widget].
  QRectF box_of(std::size_t node) const;
  double scale() const { return to_widget_.m11(); }

  QSize sizeHint() const override { return {800, 500}; }
  QSize minimumSizeHint() const override { return {240, 160}; }

 Q_SIGNALS:
  void selected_changed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void take_structure();
  void zoom_at(const QPointF& point, double factor);
  void go(int dx, int dy);
  std::optional<std::size_t> node_at(const QPointF& point) const;

  GraphModel& model_;
  Theme theme_ = Theme::light();
  QTransform to_widget_;
  bool fitted_ = true;  // and stays so when the widget's size changes
  std::optional<std::size_t> selected_;
  QPointF dragged_from_;
};

}  // namespace trocar::gui
