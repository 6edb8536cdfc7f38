// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QWidget>
#include <optional>
#include <string>

#include "gui/analysis/time_view.hpp"
#include "gui/data/data_store.hpp"
#include "gui/plots/autoscale.hpp"
#include "gui/plots/custom_plot.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// One signal over another, for the last seconds or about a trigger: force over depth, y over x.
class XyPlot : public QWidget {
  Q_OBJECT

 public:
  explicit XyPlot(DataStore& store, QWidget* parent = nullptr);

  void set_title(const QString& title);
  /// Both of the same thread, or nothing is drawn and the title says so.
  void set_signals(const std::string& x, const std::string& y);
  const std::string& x() const { return x_; }
  const std::string& y() const { return y_; }
  void set_view(const TimeView& view) { view_ = view; }
  void set_cap(double value);
  void set_theme(const Theme& theme);
  void freeze(std::optional<double> at) { view_.frozen = at; }
  void refresh();
  QCustomPlot& canvas() { return *plot_; }
  QString heading() const { return title_->text(); }

 private:
  QString axis_text(const std::string& signal, int room) const;
  void show_title();
  bool take_points(const SignalRef& x, const SignalRef& y);

  DataStore& data_;
  QLabel* title_;
  QCustomPlot* plot_;
  QCPCurve* curve_;
  QCPGraph* now_;
  std::vector<QCPItemStraightLine*> caps_;
  Autoscale x_scale_, y_scale_;
  std::string x_, y_;
  QString name_, trouble_;
  QVector<QCPCurveData> points_;
  Extremes xs_, ys_;  // of them
  Theme theme_ = Theme::light();
  TimeView view_;
};

}  // namespace trocar::gui
