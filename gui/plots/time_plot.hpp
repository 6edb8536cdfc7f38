// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/analysis/time_view.hpp"
#include "gui/data/data_store.hpp"
#include "gui/plots/autoscale.hpp"
#include "gui/plots/binned_curve.hpp"
#include "gui/plots/custom_plot.hpp"
#include "gui/plots/plot_legend.hpp"
#include "gui/plots/plot_marks.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// Signals over the last seconds, or about a trigger. The time axis tells how long ago, so that its
/// ticks stay while the curves move: of a frame only the curves are drawn anew. Values are shown in
/// the units that people read: shown_unit().
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
  double span() const { return view_.span; }
  void set_view(const TimeView& view);
  TimeWindow window() const { return view_.at(data_.now()); }
  /// Lines across the plot.
  PlotMarks& marks() { return marks_; }
  /// The axis always shows it, with a line, on both sides of 0.
  void set_cap(double value);
  /// Where that signal is below 1, the gate held back: that time is shaded.
  void set_saturation(const std::string& signal);
  void set_theme(const Theme& theme);

  /// Stops the picture; the run and its recording go on. Nothing: it follows again.
  void freeze(std::optional<double> at);
  bool frozen() const { return view_.frozen.has_value(); }

  /// Draws the newest.
  void refresh();
  QCustomPlot& canvas() { return *plot_; }
  QString heading() const { return title_->text() + "&nbsp;&nbsp;" + legend_->html(); }
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
  void draw(Curve& curve, const TimeWindow& window);
  void draw_saturation(const TimeWindow& window);
  QString common_name() const;
  QString notice() const;
  void label();

  DataStore& data_;
  QString name_;
  QLabel* title_;
  PlotLegend* legend_;
  QCustomPlot* plot_;
  QCPLayer* curves_layer_;
  PlotMarks marks_;
  std::vector<std::unique_ptr<Curve>> curves_;
  Curve saturation_;
  QCPGraph* shade_ = nullptr;
  std::vector<QCPItemStraightLine*> caps_;
  Autoscale scale_;
  Theme theme_ = Theme::light();
  TimeView view_;
  bool all_ = true;       // axes changed: more than the curves is to be drawn
  double labelled_ = -1;  // [s] when the legend was written
  QVector<QCPGraphData> points_;
};

}  // namespace trocar::gui
