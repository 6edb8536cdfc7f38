// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "gui/plots/autoscale.hpp"
#include "gui/plots/binned_curve.hpp"
#include "gui/plots/custom_plot.hpp"
#include "gui/timing/timing_model.hpp"

namespace trocar::gui {

/// What each tick left of the period, over the last seconds: of each moment the least. Below 0 a
/// tick took longer than there is time.
class MarginPlot : public QWidget {
  Q_OBJECT

 public:
  static constexpr double span = 30.0;  // [s]

  MarginPlot(const DataStore& store, const TimingModel& model, QWidget* parent = nullptr);

  void refresh();
  void set_theme(const Theme& theme);
  /// [% of the period], the least that is seen; NaN where nothing is.
  double least() const { return least_; }

 private:
  void make_graphs();

  const DataStore& data_;
  const TimingModel& model_;
  QCustomPlot* plot_;
  QCPItemStraightLine* deadline_;
  std::vector<BinnedCurve> bins_;
  Autoscale scale_;
  double least_;
  Theme theme_ = Theme::light();
};

}  // namespace trocar::gui
