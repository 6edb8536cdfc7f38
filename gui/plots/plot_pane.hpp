// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <QWidget>

#include "gui/analysis/plot_layout.hpp"
#include "gui/analysis/value_table.hpp"
#include "gui/plots/plot_gestures.hpp"
#include "gui/plots/time_plot.hpp"
#include "gui/plots/xy_plot.hpp"

namespace trocar::gui {

/// A plot of a board, onto which signals can be dropped.
class PlotPane : public QWidget {
  Q_OBJECT

 public:
  PlotPane(DataStore& store, const PlotDescription& description, QWidget* parent = nullptr);

  PlotDescription description() const;  // its height is the board's
  /// Of kind xy: the last two are x and y, and of one the y.
  void add_signals(const QStringList& names);
  void remove_signal(const std::string& name);
  void set_number(int number);  // on the board, from 1
  void set_title(const QString& title);
  void set_chosen(bool chosen);
  void set_view(const TimeView& view);
  void set_cursors(const std::optional<Cursors>& cursors);
  /// @param level in the unit of `signal`: a line where that is shown
  void set_level(const std::string& signal, std::optional<double> level);
  void set_events_shown(bool shown);
  void set_theme(const Theme& theme);
  void refresh();

  QCustomPlot& canvas();
  QString heading() const;                        // title, curves and values, as rich text
  PlotGestures* gestures() { return gestures_; }  // null: no plot over time

 Q_SIGNALS:
  void touched();
  void curves_changed();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  DataStore& data_;
  PlotDescription description_;
  TimePlot* time_ = nullptr;
  XyPlot* xy_ = nullptr;
  PlotGestures* gestures_ = nullptr;
  QLabel* hint_;
  Theme theme_ = Theme::light();
  int number_ = 1;
  bool chosen_ = false;
};

}  // namespace trocar::gui
