// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractSlider>

#include "gui/playback/playback_clock.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// A run from end to end: what of it is loaded, its marked events, the loop, and a handle where
/// playback stands, for the mouse and for keys: left and right a tick, with Shift a second, page up
/// and down a tenth of the run, home and end.
class TimeLine : public QAbstractSlider {
  Q_OBJECT

 public:
  static constexpr double unit = 1e-4;  // [s] of value()

  TimeLine(DataStore& store, LogFeed& feed, PlaybackClock& clock, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  QSize sizeHint() const override { return {400, 44}; }
  QSize minimumSizeHint() const override { return {160, 44}; }
  /// Where a time lies from the left [px], and the other way round [s].
  double x_of(double time) const;
  double time_at(double x) const;

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool event(QEvent* event) override;  // tool tips of events

 private:
  void follow_log();
  void follow_clock();
  const RunEvent* event_near(double x) const;
  void paint_bar(QPainter& painter) const;
  void paint_numbers(QPainter& painter) const;
  void paint_event(QPainter& painter, const RunEvent& event) const;
  void paint_handle(QPainter& painter) const;

  DataStore& store_;
  LogFeed& feed_;
  PlaybackClock& clock_;
  Theme theme_ = Theme::light();
  bool following_ = false;  // the clock moved, not the user
};

}  // namespace trocar::gui
