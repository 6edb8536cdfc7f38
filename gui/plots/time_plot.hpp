// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/data/data_store.hpp"
#include "gui/plots/autoscale.hpp"
#include "gui/plots/binned_curve.hpp"
#include "gui/plots/custom_plot.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// Signals over the last seconds. The time axis tells how long ago, so that its ticks stay while
/// the curves move: of a frame only the curves are drawn anew.
class TimePlot : public QWidget {
  Q_OBJECT

 public:
  explicit TimePlot(DataStore& store, QWidget* parent = nullptr);

  void set_title(const QString& title);
  /// A signal that the run does not have, or not yet, is kept in the legend without values.
  void add_curve(const std::string& signal);
  void remove_curve(const std::string& signal);
  void clear_curves();
  std::vector<std::string> curve_names() const;

  void set_span(double seconds);
  double span() const { return span_; }
  /// The axis always shows it, with a line, on both sides of 0.
  void set_cap(double value);
  /// Where that signal is below 1, the gate held back: that time is shaded.
  void set_saturation(const std::string& signal);
  void set_theme(const Theme& theme);

  /// Stops the picture; the run and its recording go on. Nothing: it follows again.
  void freeze(std::optional<double> at);
  bool frozen() const { return frozen_.has_value(); }
  /// [s] of its right edge.
  double end() const { return frozen_.value_or(data_.now()); }

  /// Draws the newest.
  void refresh();
  QCustomPlot& canvas() { return *plot_; }
  /// Least and greatest of the value axis.
  QCPRange value_range() const { return plot_->yAxis->range(); }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Curve {
    std::string signal;
    BinnedCurve bins;
    QCPGraph* graph = nullptr;
  };
  void resolve(Curve& curve);
  void draw(Curve& curve, double end);
  void draw_saturation(double end);
  QString common_name() const;
  void label();
  void redraw_all();

  DataStore& data_;
  QString name_;
  QLabel* title_;
  QLabel* legend_;
  QCustomPlot* plot_;
  QCPLayer* curves_layer_;
  std::vector<std::unique_ptr<Curve>> curves_;
  Curve saturation_;
  QCPGraph* shade_ = nullptr;
  std::vector<QCPItemStraightLine*> caps_;
  Autoscale scale_;
  Theme theme_ = Theme::light();
  double span_ = 10.0;
  std::optional<double> frozen_;
  bool all_ = true;       // axes changed: more than the curves is to be drawn
  double labelled_ = -1;  // [s] when the legend was written
  QVector<QCPGraphData> points_;
};

}  // namespace trocar::gui
