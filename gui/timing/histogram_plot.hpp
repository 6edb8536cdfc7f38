// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "gui/plots/custom_plot.hpp"
#include "gui/timing/timing_model.hpp"

namespace trocar::gui {

/// How often ticks were how late, and took how long: both axes logarithmic, so that the one tick in
/// a million that was late is seen beside all others.
class HistogramPlot : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramPlot(const TimingModel& model, QWidget* parent = nullptr);

  void refresh();
  void set_theme(const Theme& theme);

  /// A point of the outline: from `time` [µs] on there are `count` samples in each bin.
  struct Step {
    double time = 0.0;
    double count = 0.0;
  };
  /// Bins of the histogram, four to each factor of two, with the empty ones between.
  static std::vector<Step> steps_of(const TimingHistogram& histogram);

 private:
  void make_graphs();
  void show(QCPGraph& graph, const TimingHistogram& histogram);

  const TimingModel& model_;
  QCustomPlot* plot_;
  Theme theme_ = Theme::light();
};

}  // namespace trocar::gui
