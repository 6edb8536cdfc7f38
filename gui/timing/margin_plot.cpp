// SPDX-License-Identifier: Apache-2.0
#include "gui/timing/margin_plot.hpp"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gui/plots/plot_look.hpp"

namespace trocar::gui {

MarginPlot::MarginPlot(const DataStore& store, const TimingModel& model, QWidget* parent)
    : QWidget(parent),
      data_(store),
      model_(model),
      plot_(new QCustomPlot(this)),
      deadline_(new QCPItemStraightLine(plot_)),
      least_(std::numeric_limits<double>::quiet_NaN()) {
  setObjectName("margin_plot");
  setAccessibleName("margin to the deadline over time");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumSize(200, 120);
  plot_->xAxis->setLabel("time before now [s]");
  plot_->yAxis->setLabel("left of the period [%]");
  plot_->xAxis->setRange(-span, 0.0);
  plot_->legend->setVisible(true);
  plot_->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignBottom | Qt::AlignLeft);
  deadline_->point1->setCoords(0.0, 0.0);
  deadline_->point2->setCoords(1.0, 0.0);
  scale_.include(0.0);
  scale_.include(100.0);
  connect(&model_, &TimingModel::threads_changed, this, &MarginPlot::make_graphs);
  make_graphs();
}

void MarginPlot::make_graphs() {
  plot_->clearGraphs();
  bins_.assign(model_.threads().size(), {});
  for (std::size_t i = 0; i < model_.threads().size(); ++i) {
    QCPGraph* graph = plot_->addGraph();
    graph->setName(QString::fromStdString(model_.threads()[i]->name()));
    graph->setPen(theme_.curve(i));
  }
}

void MarginPlot::refresh() {
  Extremes seen;
  const double now = data_.now();
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    const ThreadTiming& thread = *model_.threads()[i];
    const auto duration = thread.track().find("duration");
    QVector<QCPGraphData> points;
    if (duration && thread.period() > 0.0 && !thread.all_zero()) {
      bins_[i].show({&thread.track(), *duration}, now, span, std::max(width() / 2, 50));
      for (const BinnedCurve::Bin& bin : bins_[i].bins()) {
        if (bin.extremes.empty()) continue;
        const double left = 100.0 * (1.0 - 1e-9 * bin.extremes.max / thread.period());
        points.append({(static_cast<double>(bin.number) + 0.5) * bins_[i].width() - now, left});
        seen.add(left);
      }
    }
    plot_->graph(static_cast<int>(i))->data()->set(points, true);
  }
  least_ = seen.empty() ? std::numeric_limits<double>::quiet_NaN() : seen.min;
  if (scale_.follow(seen, now)) plot_->yAxis->setRange(scale_.lower(), scale_.upper());
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void MarginPlot::set_theme(const Theme& theme) {
  theme_ = theme;
  set_plot_look(*plot_, theme);
  deadline_->setPen(QPen(theme.danger, 1.5, Qt::DashLine));
  make_graphs();
  refresh();
}

}  // namespace trocar::gui
