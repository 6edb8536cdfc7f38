// SPDX-License-Identifier: Apache-2.0
#include "gui/plots/xy_plot.hpp"

#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "gui/data/shown_number.hpp"
#include "gui/plots/plot_look.hpp"

namespace trocar::gui {
namespace {

constexpr std::uint64_t most_stretches = 500;

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
  show_title();
  setAccessibleName(title);
}

void XyPlot::set_signals(const std::string& x, const std::string& y) {
  x_ = x;
  y_ = y;
  x_scale_ = y_scale_ = {};
  show_title();
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
  set_plot_look(*plot_, theme);
  curve_->setPen(theme.curve(0));
  now_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, theme.danger, theme.danger, 7));
  for (QCPItemStraightLine* line : caps_) line->setPen(QPen(theme.danger, 1, Qt::DashLine));
}

/// With its unit; where it would be cut off, the unit alone: the title has the name.
QString XyPlot::axis_text(const std::string& signal, int room) const {
  const auto found = data_.find(signal);
  const QString name = QString::fromStdString(signal);
  const QString unit = found ? shown_unit(found->info().unit) : QString();
  const QString shown = unit.isEmpty() ? QString() : "[" + unit + "]";
  const QString whole = shown.isEmpty() ? name : name + " " + shown;
  return QFontMetrics(plot_->yAxis->labelFont()).horizontalAdvance(whole) < room ? whole : shown;
}

void XyPlot::show_title() {
  const QString what = !trouble_.isEmpty() ? trouble_
                       : y_.empty()        ? QString()
                                           : QString::fromStdString(y_ + " over " + x_);
  title_->setText("<b>" + name_.toHtmlEscaped() + "</b>&nbsp;&nbsp;" + what.toHtmlEscaped());
}

/// Of some hundred stretches of rows each the first, and those with the extremes of either signal:
/// what lasted one tick is seen.
bool XyPlot::take_points(const SignalRef& x, const SignalRef& y) {
  const TimeWindow window = view_.at(data_.now());
  const Track& track = *x.track;
  const std::uint64_t begin = track.at(window.begin);
  const std::uint64_t end = track.at(std::nextafter(window.end, 1e300));
  const std::uint64_t step = std::max<std::uint64_t>(1, (end - begin) / most_stretches);
  const double x_scale = shown_scale(x.info().unit), y_scale = shown_scale(y.info().unit);
  for (std::uint64_t first = begin; first < end; first += step) {
    const std::uint64_t last = std::min(end, first + step);
    std::array<std::uint64_t, 5> rows = {first, first, first, first, first};
    Extremes xs, ys;
    for (std::uint64_t row = first; row < last; ++row) {
      const double px = x.column()[row], py = y.column()[row];
      if (px < xs.min) rows[1] = row;
      if (px > xs.max) rows[2] = row;
      if (py < ys.min) rows[3] = row;
      if (py > ys.max) rows[4] = row;
      xs.add(px);
      ys.add(py);
    }
    std::sort(rows.begin(), rows.end());
    const auto distinct = std::unique(rows.begin(), rows.end());
    for (auto row = rows.begin(); row != distinct; ++row) {
      const double px = x_scale * x.column()[*row], py = y_scale * y.column()[*row];
      points_.append({static_cast<double>(*row), px, py});
      xs_.add(px);
      ys_.add(py);
    }
  }
  return !points_.empty();
}

void XyPlot::refresh() {
  const auto x = data_.find(x_), y = data_.find(y_);
  points_.clear();
  xs_ = ys_ = {};
  QVector<QCPGraphData> newest;
  QString trouble;
  if (x && y && x->track != y->track)
    trouble = "these are of two threads, whose rows do not belong together";
  else if (x && y && take_points(*x, *y))
    newest.append({points_.back().key, points_.back().value});
  if (trouble != trouble_) {
    trouble_ = trouble;
    show_title();
  }
  curve_->data()->set(points_, true);
  now_->data()->set(newest, true);
  if (x_scale_.follow(xs_, data_.now())) plot_->xAxis->setRange(x_scale_.lower(), x_scale_.upper());
  if (y_scale_.follow(ys_, data_.now())) plot_->yAxis->setRange(y_scale_.lower(), y_scale_.upper());
  plot_->xAxis->setLabel(axis_text(x_, plot_->axisRect()->width()));
  plot_->yAxis->setLabel(axis_text(y_, plot_->axisRect()->height()));
  plot_->replot(QCustomPlot::rpImmediateRefresh);
}

}  // namespace trocar::gui
