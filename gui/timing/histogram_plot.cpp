// SPDX-License-Identifier: Apache-2.0
#include "gui/timing/histogram_plot.hpp"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <map>

#include "gui/plots/plot_look.hpp"

namespace trocar::gui {
namespace {

constexpr int bins_of_a_double = 4;
constexpr double least_time = 0.1;   // [µs] of the axis: below it nothing is told apart
constexpr double least_count = 0.5;  // of the axis: 0 has no logarithm, and 1 is to be seen

/// The bin's lower edge [µs].
double edge_of(int bin) {
  return least_time * std::exp2(static_cast<double>(bin) / bins_of_a_double);
}

int bin_of(double time) {
  return std::max(0, static_cast<int>(std::floor(
                         bins_of_a_double * std::log2(std::max(time, least_time) / least_time))));
}

}  // namespace

HistogramPlot::HistogramPlot(const TimingModel& model, QWidget* parent)
    : QWidget(parent), model_(model), plot_(new QCustomPlot(this)) {
  setObjectName("timing_histogram");
  setAccessibleName("histogram of lateness and of ticks");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumSize(200, 120);
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setTicker(QSharedPointer<QCPAxisTickerLog>(new QCPAxisTickerLog));
    axis->setNumberFormat("gb");
    axis->setNumberPrecision(4);
  }
  plot_->yAxis->setNumberFormat("eb");
  plot_->yAxis->setNumberPrecision(0);
  plot_->xAxis->setLabel("time [µs]");
  plot_->yAxis->setLabel("ticks");
  plot_->legend->setVisible(true);
  connect(&model_, &TimingModel::threads_changed, this, &HistogramPlot::make_graphs);
  make_graphs();
}

void HistogramPlot::make_graphs() {
  plot_->clearGraphs();
  std::size_t n = 0;
  for (const auto& thread : model_.threads())
    for (const char* what : {"late", "tick"}) {
      QCPGraph* graph = plot_->addGraph();
      graph->setName(QString::fromStdString(thread->name()) + ": " + what);
      graph->setLineStyle(QCPGraph::lsStepLeft);
      QPen pen = theme_.curve(n++);
      pen.setStyle(std::string_view(what) == "late" ? Qt::SolidLine : Qt::DashLine);
      pen.setWidthF(1.4);
      graph->setPen(pen);
    }
}

std::vector<HistogramPlot::Step> HistogramPlot::steps_of(const TimingHistogram& histogram) {
  std::map<int, double> counts;
  for (const TimingHistogram::Bin& bin : histogram.bins())
    counts[bin_of(0.5e-3 * static_cast<double>(bin.lower + bin.upper))] +=
        static_cast<double>(bin.count);
  std::vector<Step> steps;
  if (counts.empty()) return steps;
  for (int bin = counts.begin()->first; bin <= counts.rbegin()->first; ++bin) {
    const auto found = counts.find(bin);
    steps.push_back({edge_of(bin), found == counts.end() ? 0.0 : found->second});
  }
  steps.push_back({edge_of(counts.rbegin()->first + 1), 0.0});
  return steps;
}

void HistogramPlot::show(QCPGraph& graph, const TimingHistogram& histogram) {
  QVector<QCPGraphData> points;
  for (const Step& step : steps_of(histogram)) {
    if (points.empty()) points.append({step.time, least_count});
    points.append({step.time, std::max(step.count, least_count)});
  }
  graph.data()->set(points, true);
}

void HistogramPlot::refresh() {
  int n = 0;
  double longest = 10.0, most = 10.0;
  for (const auto& thread : model_.threads())
    for (const TimingHistogram* histogram : {&thread->lateness(), &thread->duration()}) {
      show(*plot_->graph(n++), *histogram);
      longest = std::max(longest, 1e-3 * static_cast<double>(histogram->max()));
      most = std::max(most, static_cast<double>(histogram->count()));
    }
  // Whole decades: the axes move rarely.
  plot_->xAxis->setRange(least_time, std::pow(10.0, std::ceil(std::log10(longest * 1.2))));
  plot_->yAxis->setRange(least_count, std::pow(10.0, std::ceil(std::log10(most))));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void HistogramPlot::set_theme(const Theme& theme) {
  theme_ = theme;
  set_plot_look(*plot_, theme);
  make_graphs();
  refresh();
}

}  // namespace trocar::gui
