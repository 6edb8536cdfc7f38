// SPDX-License-Identifier: Apache-2.0
#include "gui/plots/time_plot.hpp"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/data/shown_number.hpp"
#include "gui/plots/plot_look.hpp"

namespace trocar::gui {
namespace {

constexpr double label_interval = 0.2;  // [s] between texts that people have to read
constexpr double least_scale = 0.999;   // below it the gate held back

/// Room for numbers of any length, so that plots under each other have one time axis.
constexpr QMargins margins(64, 6, 10, 34);

/// On top of all else, which is then one picture beneath: of a frame two are put together and not
/// four.
QCPLayer* buffered_layer(QCustomPlot& plot) {
  plot.layer("overlay")->setMode(QCPLayer::lmLogical);
  plot.addLayer("curves", plot.layer("overlay"), QCustomPlot::limAbove);
  plot.layer("curves")->setMode(QCPLayer::lmBuffered);
  return plot.layer("curves");
}

Extremes scaled(const Extremes& extremes, double scale) {
  return {scale * extremes.min, scale * extremes.max};
}

}  // namespace

TimePlot::TimePlot(DataStore& store, QWidget* parent)
    : QWidget(parent),
      data_(store),
      title_(new QLabel(this)),
      legend_(new PlotLegend(this)),
      plot_(new QCustomPlot(this)),
      curves_layer_(buffered_layer(*plot_)),
      marks_(*plot_, *curves_layer_) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 2, 4, 2);
  layout->setSpacing(0);
  auto* head = new QHBoxLayout;
  head->addWidget(title_);
  head->addStretch(1);
  head->addWidget(legend_);
  layout->addLayout(head);
  layout->addWidget(plot_, 1);

  plot_->axisRect()->setAutoMargins(QCP::msNone);
  plot_->axisRect()->setMargins(margins);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->setPlottingHints(QCP::phFastPolylines | QCP::phCacheLabels);
  plot_->xAxis->setLabelPadding(1);
  shade_ = plot_->addGraph();
  shade_->setLayer(curves_layer_);
  shade_->setPen(Qt::NoPen);
  setMinimumSize(160, 90);
  set_view(view_);
  set_theme(theme_);
  connect(&data_, &DataStore::run_began, this, [this] {
    for (auto& curve : curves_) curve->bins.clear();
    saturation_.bins.clear();
    freeze({});
  });
}

void TimePlot::set_title(const QString& title) {
  name_ = title;
  labelled_ = -1;
  title_->setText("<b>" + title.toHtmlEscaped() + "</b>");
  setAccessibleName(title);
}

void TimePlot::add_curve(const std::string& signal) {
  auto curve = std::make_unique<Curve>();
  curve->signal = signal;
  curve->graph = plot_->addGraph();
  curve->graph->setLayer(curves_layer_);
  curve->graph->setAdaptiveSampling(false);  // done already
  curve->graph->setPen(theme_.curve(curves_.size()));
  curves_.push_back(std::move(curve));
  labelled_ = -1;
}

void TimePlot::remove_curve(const std::string& signal) {
  const auto found = std::find_if(curves_.begin(), curves_.end(),
                                  [&](const auto& one) { return one->signal == signal; });
  if (found == curves_.end()) return;
  plot_->removeGraph((*found)->graph);
  curves_.erase(found);
  set_theme(theme_);
}

void TimePlot::clear_curves() {
  while (!curves_.empty()) remove_curve(curves_.back()->signal);
}

std::vector<std::string> TimePlot::curve_names() const {
  std::vector<std::string> names;
  for (const auto& curve : curves_) names.push_back(curve->signal);
  return names;
}

void TimePlot::set_span(double seconds) {
  TimeView view = view_;
  view.span = seconds;
  set_view(view);
}

void TimePlot::set_view(const TimeView& view) {
  if (view.frozen != view_.frozen || view.shot != view_.shot) labelled_ = -1;
  view_ = view;
  const TimeWindow at = window();
  const QCPRange range(at.begin - at.zero, at.end - at.zero);
  const QString label = view.shot ? "time after the trigger [s]" : "time before now [s]";
  if (plot_->xAxis->range() == range && plot_->xAxis->label() == label) return;
  plot_->xAxis->setRange(range);
  plot_->xAxis->setLabel(label);
  all_ = true;
}

void TimePlot::set_cap(double value) {
  for (QCPItemStraightLine* line : caps_) plot_->removeItem(line);
  caps_.clear();
  for (const double at : {value, -value}) {
    auto* line = new QCPItemStraightLine(plot_);
    line->point1->setCoords(0, at);
    line->point2->setCoords(1, at);
    caps_.push_back(line);
    scale_.include(at);
  }
  set_theme(theme_);
}

void TimePlot::set_saturation(const std::string& signal) {
  saturation_.signal = signal;
  saturation_.bins.clear();
}

void TimePlot::set_theme(const Theme& theme) {
  theme_ = theme;
  set_plot_look(*plot_, theme);
  marks_.set_theme(theme);
  legend_->set_theme(theme);
  for (std::size_t i = 0; i < curves_.size(); ++i) curves_[i]->graph->setPen(theme.curve(i));
  for (QCPItemStraightLine* line : caps_) line->setPen(QPen(theme.danger, 1, Qt::DashLine));
  QColor shade = theme.warning;
  shade.setAlpha(70);
  shade_->setBrush(shade);
  labelled_ = -1;
  all_ = true;
}

void TimePlot::freeze(std::optional<double> at) {
  TimeView view = view_;
  view.frozen = at;
  set_view(view);
}

void TimePlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  all_ = true;
}

void TimePlot::refresh() {
  const TimeWindow shown = window();
  Extremes extremes;
  for (auto& curve : curves_) {
    draw(*curve, shown);
    const auto signal = data_.find(curve->signal);
    const double scale = signal ? shown_scale(signal->info().unit) : 1.0;
    extremes.add(scaled(curve->bins.extremes(), scale));
  }
  if (const auto level = marks_.level()) extremes.add(*level);
  if (scale_.follow(extremes, data_.now())) {
    plot_->yAxis->setRange(scale_.lower(), scale_.upper());
    all_ = true;
  }
  draw_saturation(shown);
  marks_.show_events(data_, shown);
  label();
  if (all_)
    plot_->replot(QCustomPlot::rpImmediateRefresh);
  else
    curves_layer_->replot();
  all_ = false;
}

void TimePlot::draw(Curve& curve, const TimeWindow& window) {
  const auto signal = data_.find(curve.signal);
  points_.clear();
  if (signal && !signal->track->empty()) {
    curve.bins.show(*signal, window.end, window.end - window.begin,
                    std::max(10, plot_->axisRect()->width()));
    const double scale = shown_scale(signal->info().unit);
    for (const BinnedCurve::Bin& bin : curve.bins.bins()) {
      const double at = (static_cast<double>(bin.number) + 0.5) * curve.bins.width() - window.zero;
      if (bin.after_gap || bin.extremes.empty()) points_.append({at, std::nan("")});
      if (bin.extremes.empty()) continue;
      points_.append({at, scale * bin.extremes.min});
      if (bin.extremes.max > bin.extremes.min) points_.append({at, scale * bin.extremes.max});
    }
  } else {
    curve.bins.clear();
  }
  curve.graph->data()->set(points_, true);
}

void TimePlot::draw_saturation(const TimeWindow& window) {
  const auto signal = saturation_.signal.empty() ? std::nullopt : data_.find(saturation_.signal);
  points_.clear();
  if (signal && !signal->track->empty()) {
    saturation_.bins.show(*signal, window.end, window.end - window.begin, 200);
    const double top = plot_->yAxis->range().upper;
    for (const BinnedCurve::Bin& bin : saturation_.bins.bins()) {
      const double at = static_cast<double>(bin.number) * saturation_.bins.width() - window.zero;
      const double height = bin.extremes.min < least_scale ? top : 0.0;
      points_.append({at, height});
      points_.append({at + saturation_.bins.width(), height});
    }
  }
  shade_->data()->set(points_, true);
}

/// What the names of all curves begin with, up to a dot: "wall.force" of "wall.force.x" and so on.
QString TimePlot::common_name() const {
  if (curves_.size() < 2) return "";
  std::string common = curves_.front()->signal;
  for (const auto& curve : curves_) {
    const auto differ =
        std::mismatch(common.begin(), common.end(), curve->signal.begin(), curve->signal.end());
    common.erase(differ.first, common.end());
  }
  const std::size_t dot = common.rfind('.');
  return dot == std::string::npos ? "" : QString::fromStdString(common.substr(0, dot));
}

QString TimePlot::notice() const {
  if (view_.shot) return QString("TRIGGERED at %1 s").arg(view_.shot->at, 0, 'f', 4);
  if (!view_.frozen) return "";
  return QString("FROZEN, behind %1 s; the run goes on")
      .arg(data_.now() - *view_.frozen, 0, 'f', 1);
}

/// Names, colours, last values and units, a few times a second.
void TimePlot::label() {
  const double now = data_.now();
  if (labelled_ >= 0 && std::abs(now - labelled_) < label_interval) return;
  labelled_ = now;
  QString units;
  const QString common = common_name();
  const qsizetype skipped = common.isEmpty() ? 0 : common.size() + 1;
  const QString title = QString("<b>%1</b>&nbsp;&nbsp;%2").arg(name_.toHtmlEscaped(), common);
  if (title != title_->text()) title_->setText(title);
  std::vector<PlotLegend::Entry> entries;
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const auto signal = data_.find(curves_[i]->signal);
    entries.push_back({.pen = theme_.curve(i),
                       .name = QString::fromStdString(curves_[i]->signal).mid(skipped),
                       .value = {}});
    if (!signal || !std::isfinite(signal->last())) continue;
    entries.back().value = shown_number(signal->last(), signal->info().unit);
    const QString unit = shown_unit(signal->info().unit);
    if (!unit.isEmpty() && !units.contains(unit)) units += (units.isEmpty() ? "" : ", ") + unit;
  }
  legend_->show_entries(notice(), std::move(entries));
  const QString axis = units.isEmpty() ? QString() : "[" + units + "]";
  if (axis == plot_->yAxis->label()) return;
  plot_->yAxis->setLabel(axis);
  all_ = true;
}

}  // namespace trocar::gui
