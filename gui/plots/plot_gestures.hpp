// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <array>
#include <optional>

#include "gui/plots/custom_plot.hpp"

namespace trocar::gui {

/// What is done to a plot over time by mouse and keys: told, not carried out, since all plots of a
/// page show the same time.
/// Dragging moves the picture, or the cursor that it begins at; the wheel, + and − zoom; the arrow
/// keys move the picture, with Ctrl cursor A and with Shift cursor B.
class PlotGestures : public QObject {
  Q_OBJECT

 public:
  explicit PlotGestures(QCustomPlot& plot);

  /// Where cursors can be taken hold of [s], on the axis.
  void set_cursors(const std::optional<std::array<double, 2>>& cursors) { cursors_ = cursors; }

 Q_SIGNALS:
  void touched();
  void scrubbed(double seconds);  // the right edge is to be so much later
  void zoomed(double factor);     // so many times the span
  void cursor_moved(int which, double at);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void press(const QPointF& at);
  void move(const QPointF& at);
  bool press_key(const QKeyEvent& key);
  double time_at(double x) const { return plot_.xAxis->pixelToCoord(x); }

  QCustomPlot& plot_;
  std::optional<std::array<double, 2>> cursors_;
  std::optional<QPointF> held_;  // where the mouse was last
  int cursor_ = -1;              // that is dragged
};

}  // namespace trocar::gui
