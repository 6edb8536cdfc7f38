// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QWidget>
#include <optional>
#include <string>

#include "gui/data/data_store.hpp"
#include "gui/plots/autoscale.hpp"
#include "gui/plots/custom_plot.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// One signal over another, for the last seconds: force over depth, y over x.
class XyPlot : public QWidget {
  Q_OBJECT

 public:
  explicit XyPlot(DataStore& store, QWidget* parent = nullptr);

  void set_title(const QString& title);
  /// Both of the same thread, or nothing is drawn and the title says so.
  void set_signals(const std::string& x, const std::string& y);
  void set_span(double seconds) { span_ = seconds; }
  void set_cap(double value);
  void set_theme(const Theme& theme);
  void freeze(std::optional<double> at) { frozen_ = at; }
  void refresh();
  QCustomPlot& canvas() { return *plot_; }

 private:
  QString axis_text(const std::string& signal) const;

  DataStore& data_;
  QLabel* title_;
  QCustomPlot* plot_;
  QCPCurve* curve_;
  QCPGraph* now_;
  std::vector<QCPItemStraightLine*> caps_;
  Autoscale x_scale_, y_scale_;
  std::string x_, y_;
  QString name_;
  Theme theme_ = Theme::light();
  double span_ = 10.0;
  std::optional<double> frozen_;
};

}  // namespace trocar::gui
