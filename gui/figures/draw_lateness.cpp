// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "gui/figures/figure.hpp"
#include "gui/figures/lateness.hpp"

namespace trocar::gui {
namespace {

constexpr double least_count = 0.5;  // where an axis of counts begins that has no zero

void set_logarithmic(QCPAxisRect& panel) {
  for (const QCPAxis::AxisType type :
       {QCPAxis::atLeft, QCPAxis::atBottom, QCPAxis::atRight, QCPAxis::atTop}) {
    panel.axis(type)->setScaleType(QCPAxis::stLogarithmic);
    panel.axis(type)->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    panel.axis(type)->setNumberFormat("gb");
    panel.axis(type)->setNumberPrecision(6);
  }
}

/// The bins as one outline that goes down where there are none.
void draw_bins(FigureSheet& sheet, QCPAxisRect& panel, const Lateness& lateness) {
  QVector<double> at, count;
  const auto add = [&](double seconds, double ticks) {
    at.push_back(1e6 * seconds);
    count.push_back(ticks);
  };
  for (const Lateness::Bin& bin : lateness.bins) {
    if (!(bin.from > 0.0)) continue;
    add(bin.from, least_count);
    add(bin.from, static_cast<double>(bin.count));
    add(bin.to, static_cast<double>(bin.count));
    add(bin.to, least_count);
  }
  QCPGraph& outline = sheet.add_curve(panel);
  outline.setAdaptiveSampling(false);
  outline.setData(at, count, true);
  outline.setPen(FigureSheet::line(0.15));
  outline.setBrush(QColor("#c8c8c8"));
}

void draw_mark(FigureSheet& sheet, QCPAxisRect& panel, double seconds, std::size_t number,
               const char* name) {
  QCPGraph& mark = sheet.add_curve(panel);
  mark.setData({1e6 * seconds, 1e6 * seconds}, {least_count, 1e9});
  mark.setPen(FigureSheet::curve(number));
  mark.setName(QString::fromStdString(fmt::format("{} {:.4g} µs", name, 1e6 * seconds)));
}

}  // namespace

DrawnFigure draw_lateness(const ResultFile& file, const FigureOptions& options) {
  const Lateness lateness = lateness_of(file, options.run, options.thread);
  auto sheet = std::make_unique<FigureSheet>(60.0);
  QCPAxisRect& panel = sheet->add_panel("Lateness of a tick [µs]", "Ticks");
  set_logarithmic(panel);
  draw_bins(*sheet, panel, lateness);
  draw_mark(*sheet, panel, lateness.p50, 0, "median");
  draw_mark(*sheet, panel, lateness.p99, 1, "99 %");
  draw_mark(*sheet, panel, lateness.max, 2, "worst");
  std::size_t most = 1;
  double least = lateness.max;
  for (const Lateness::Bin& bin : lateness.bins) {
    most = std::max(most, bin.count);
    if (bin.from > 0.0) least = std::min(least, bin.from);
  }
  panel.axis(QCPAxis::atBottom)->setRange(0.8e6 * least, 8e6 * lateness.max);
  panel.axis(QCPAxis::atLeft)->setRange(least_count, 8.0 * static_cast<double>(most));
  sheet->add_legend(panel, Qt::AlignTop | Qt::AlignRight);
  return {std::move(sheet), lateness_text(lateness) + "\n"};
}

}  // namespace trocar::gui
