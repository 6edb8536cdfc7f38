// SPDX-License-Identifier: Apache-2.0
#include "gui/analysis/value_table.hpp"

#include <algorithm>
#include <cmath>

#include "gui/analysis/range_statistics.hpp"
#include "gui/data/shown_number.hpp"

namespace trocar::gui {
namespace {

CellTable::Cell cell_of(double value, const std::string& unit) {
  // A cell without a number would stand on the other side of its column.
  return {.text = shown_value(value, unit), .number = std::isfinite(value) ? value : 0.0};
}

}  // namespace

QStringList ValueTable::header() {
  return {"plot", "signal", "unit", "last", "at A",      "at B", "B − A",
          "min",  "max",    "mean", "RMS",  "deviation", "rows"};
}

QString ValueTable::difference_text(const Cursors& cursors) {
  const double difference = cursors[1] - cursors[0];
  QString text = QString("B − A  %1 ms").arg(1e3 * difference, 0, 'f', 1);
  if (difference != 0.0) text += QString(",  %1 Hz").arg(1.0 / std::abs(difference), 0, 'g', 4);
  return text;
}

void ValueTable::fill(const DataStore& data, const std::vector<PlotDescription>& plots,
                      const TimeWindow& window, const std::optional<Cursors>& cursors) {
  rows_.clear();
  sources_.clear();
  const double a = cursors ? window.zero + (*cursors)[0] : 0.0;
  const double b = cursors ? window.zero + (*cursors)[1] : 0.0;
  const double from = cursors ? std::min(a, b) : window.begin;
  const double to = cursors ? std::max(a, b) : window.end;
  for (std::size_t i = 0; i < plots.size(); ++i)
    for (const std::string& name : plots[i].names) {
      sources_.push_back({i, name});
      const auto signal = data.find(name);
      const std::string unit = signal ? signal->info().unit : "";
      CellTable::Row row = {{.text = QString::number(i + 1), .number = static_cast<double>(i + 1)},
                            {.text = QString::fromStdString(name)},
                            {.text = signal ? shown_unit(unit) : QString("–")}};
      const double nothing = std::nan("");
      const double at_a = signal && cursors ? value_at(*signal, a) : nothing;
      const double at_b = signal && cursors ? value_at(*signal, b) : nothing;
      const RangeStatistics s = signal ? statistics_of(*signal, from, to) : RangeStatistics{};
      for (const double value : {signal ? value_at(*signal, window.end) : nothing, at_a, at_b,
                                 at_b - at_a, s.min, s.max, s.mean, s.rms, s.deviation})
        row.push_back(cell_of(value, unit));
      row.push_back({.text = QString::number(s.count), .number = static_cast<double>(s.count)});
      rows_.push_back(std::move(row));
    }
}

}  // namespace trocar::gui
