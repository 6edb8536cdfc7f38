// SPDX-License-Identifier: Apache-2.0
#include "gui/plots/xy_plot.hpp"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace trocar::gui {
namespace {

constexpr std::uint64_t most_points = 2000;

}  // namespace

XyPlot::XyPlot(DataStore& store, QWidget* parent)
    : QWidget(parent), data_(store), title_(new QLabel(this)), plot_(new QCustomPlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 2, 4, 2);
  layout->setSpacing(0);
  layout->addWidget(title_);
  layout->addWidget(plot_, 1);
  plot_->axisRect()->setAutoMargins(QCP::msNone);
  plot_->axisRect()->setMargins({64, 6, 10, 34});
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->setPlottingHints(QCP::phFastPolylines | QCP::phCacheLabels);
  curve_ = new QCPCurve(plot_->xAxis, plot_->yAxis);
  now_ = plot_->addGraph();
  now_->setLineStyle(QCPGraph::lsNone);
  plot_->xAxis->setLabelPadding(1);
  setMinimumSize(160, 90);
  set_theme(theme_);
}

void XyPlot::set_title(const QString& title) {
  name_ = title;
  title_->setText("<b>" + title.toHtmlEscaped() + "</b>");
  setAccessibleName(title);
}

void XyPlot::set_signals(const std::string& x, const std::string& y) {
  x_ = x;
  y_ = y;
  x_scale_ = y_scale_ = {};
}

void XyPlot::set_cap(double value) {
  for (QCPItemStraightLine* line : caps_) plot_->removeItem(line);
  caps_.clear();
  for (const double at : {value, -value}) {
    auto* line = new QCPItemStraightLine(plot_);
    line->point1->setCoords(0, at);
    line->point2->setCoords(1, at);
    caps_.push_back(line);
    y_scale_.include(at);
  }
  set_theme(theme_);
}

void XyPlot::set_theme(const Theme& theme) {
  theme_ = theme;
  plot_->setBackground(theme.surface);
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setBasePen(QPen(theme.muted));
    axis->setTickPen(QPen(theme.muted));
    axis->setSubTickPen(QPen(theme.muted));
    axis->setTickLabelColor(theme.text);
    axis->setLabelColor(theme.text);
    axis->grid()->setPen(QPen(theme.grid));
    axis->grid()->setZeroLinePen(QPen(theme.muted));
  }
  curve_->setPen(theme.curve(0));
  now_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, theme.danger, theme.danger, 7));
  for (QCPItemStraightLine* line : caps_) line->setPen(QPen(theme.danger, 1, Qt::DashLine));
}

QString XyPlot::axis_text(const std::string& signal) const {
  const auto found = data_.find(signal);
  return QString::fromStdString(signal) +
         (found ? " [" + QString::fromStdString(found->info().unit) + "]" : QString());
}

void XyPlot::refresh() {
  const auto x = data_.find(x_), y = data_.find(y_);
  QVector<QCPCurveData> points;
  QVector<QCPGraphData> last;
  Extremes xs, ys;
  if (x && y && x->track == y->track && !x->track->empty()) {
    const double now = frozen_.value_or(data_.now());
    const std::uint64_t begin = x->track->at(now - span_);
    const std::uint64_t end = x->track->at(std::nextafter(now, 1e300));
    const std::uint64_t step = std::max<std::uint64_t>(1, (end - begin) / most_points);
    for (std::uint64_t row = begin; row < end; row += step) {
      const double px = x->column()[row], py = y->column()[row];
      points.append({static_cast<double>(row), px, py});
      xs.add(px);
      ys.add(py);
    }
    if (!points.empty()) last.append({points.back().key, points.back().value});
  }
  curve_->data()->set(points, true);
  now_->data()->set(last, true);
  if (x_scale_.follow(xs, data_.now())) plot_->xAxis->setRange(x_scale_.lower(), x_scale_.upper());
  if (y_scale_.follow(ys, data_.now())) plot_->yAxis->setRange(y_scale_.lower(), y_scale_.upper());
  plot_->xAxis->setLabel(axis_text(x_));
  plot_->yAxis->setLabel(axis_text(y_));
  plot_->replot(QCustomPlot::rpImmediateRefresh);
}

}  // namespace trocar::gui
