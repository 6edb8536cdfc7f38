// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QSortFilterProxyModel>

#include "gui/operate/operator.hpp"
#include "gui/pages/cell_view.hpp"
#include "gui/timing/histogram_plot.hpp"
#include "gui/timing/margin_plot.hpp"

namespace trocar::gui {

/// Whether the loop keeps its time, and which component costs it.
class TimingPage : public Page {
  Q_OBJECT

 public:
  explicit TimingPage(Operator& operators, QWidget* parent = nullptr);

  QString title() const override { return "Timing"; }
  QKeySequence shortcut() const override { return QKeySequence("Ctrl+8"); }
  void refresh() override;
  void set_theme(const Theme& theme) override;
  const TimingModel& model() const { return model_; }

 private:
  void build();
  void show_numbers();

  TimingModel model_;
  CellTable threads_{TimingModel::thread_header()}, components_{TimingModel::component_header()};
  QSortFilterProxyModel sorted_;
  QLabel* notice_;
  CellView *thread_table_, *component_table_;
  HistogramPlot* histogram_;
  MarginPlot* margin_;
  QElapsedTimer shown_;  // since the numbers were, which people have to read
};

}  // namespace trocar::gui
