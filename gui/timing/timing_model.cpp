// SPDX-License-Identifier: Apache-2.0
#include "gui/timing/timing_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gui/data/shown_number.hpp"
#include "gui/graph/graph_reading.hpp"

namespace trocar::gui {
namespace {

using Cell = CellTable::Cell;

/// What is not known is less than all that is.
Cell unknown_cell() {
  return {"–", -std::numeric_limits<double>::infinity()};
}

Cell duration_cell(double nanoseconds, bool known, bool warning = false) {
  if (!known) return unknown_cell();
  return {shown_duration(nanoseconds), nanoseconds, std::numeric_limits<double>::quiet_NaN(),
          warning};
}

void add_spread(const TimingHistogram& times, CellTable::Row& row) {
  const bool known = times.count() > 0;
  row.push_back(duration_cell(static_cast<double>(times.percentile(0.5)), known));
  row.push_back(duration_cell(static_cast<double>(times.percentile(0.99)), known));
  row.push_back(duration_cell(static_cast<double>(times.max()), known));
}

Cell count_cell(std::uint64_t count, bool warning) {
  return {QString::number(count), static_cast<double>(count),
          std::numeric_limits<double>::quiet_NaN(), warning};
}

Cell share_cell(double share) {
  if (!std::isfinite(share)) return unknown_cell();
  return {QString("%1 %").arg(100.0 * share, 0, 'f', 1), share, share, share > 0.8};
}

/// The component's own name: in the rows its dots are underscores.
QString name_in_graph(const std::string& name, const GraphJson& graph) {
  for (const GraphJson& node : graph_list(graph, "nodes")) {
    std::string own = graph_text(node, "name");
    const QString shown = QString::fromStdString(own);
    std::replace(own.begin(), own.end(), '.', '_');
    if (own == name) return shown;
  }
  return QString::fromStdString(name);
}

}  // namespace

TimingModel::TimingModel(const Sources& sources, QObject* parent)
    : QObject(parent), sources_(sources) {
  connect(&sources_.data, &DataStore::run_began, this, &TimingModel::read_tracks);
  read_tracks();
}

void TimingModel::read_tracks() {
  threads_.clear();
  for (const std::unique_ptr<Track>& track : sources_.data.tracks())
    threads_.push_back(std::make_unique<ThreadTiming>(*track, 0.0));
  Q_EMIT threads_changed();
}

bool TimingModel::refresh() {
  behind_ = false;
  for (const auto& thread : threads_) behind_ = !thread->take(rows_of_a_slice) || behind_;
  return !behind_;
}

void TimingModel::forget() {
  for (const auto& thread : threads_) thread->forget();
}

bool TimingModel::virtual_time() const {
  if (sources_.live != nullptr && sources_.live->state().virtual_time) return true;
  const bool any = std::any_of(threads_.begin(), threads_.end(),
                               [](const auto& thread) { return thread->ticks() > 0; });
  return any && std::all_of(threads_.begin(), threads_.end(), [](const auto& thread) {
           return thread->ticks() == 0 || thread->all_zero();
         });
}

QString TimingModel::notice() const {
  if (virtual_time())
    return "Virtual time: the run waits for nothing, and its times are all 0. With --clock "
           "realtime "
           "there are some.";
  if (std::all_of(threads_.begin(), threads_.end(),
                  [](const auto& thread) { return thread->ticks() == 0; }))
    return "No rows yet.";
  return behind_ ? "Counting the rows of the log …" : "";
}

QStringList TimingModel::thread_header() {
  return {"thread",     "rate",        "ticks",       "late median", "late 99 %",
          "late worst", "tick median", "tick 99 %",   "tick worst",  "least margin",
          "missed",     "overload",    "rows missing"};
}

std::vector<CellTable::Row> TimingModel::thread_rows() const {
  std::vector<CellTable::Row> rows;
  for (const auto& thread : threads_) {
    const double rate = thread->period() > 0.0 ? 1.0 / thread->period() : std::nan("");
    CellTable::Row row = {{QString::fromStdString(thread->name())},
                          {std::isnan(rate) ? "–" : QString("%1 Hz").arg(rate, 0, 'g', 5), rate},
                          count_cell(thread->ticks(), false)};
    add_spread(thread->lateness(), row);
    add_spread(thread->duration(), row);
    const double margin = thread->least_margin();
    row.push_back(duration_cell(margin, thread->duration().count() > 0 && thread->period() > 0.0,
                                margin < 0.2e9 * thread->period()));
    row.push_back(count_cell(thread->missed_slots(), thread->missed_slots() > 0));
    row.push_back(count_cell(thread->overloads(), thread->overloads() > 0));
    row.push_back(count_cell(thread->missing_rows(), thread->missing_rows() > 0));
    rows.push_back(std::move(row));
  }
  return rows;
}

QStringList TimingModel::component_header() {
  return {"component", "thread", "median", "99 %", "worst", "mean of the period", "ticks"};
}

std::vector<CellTable::Row> TimingModel::component_rows() const {
  std::vector<CellTable::Row> rows;
  const GraphJson& graph = graph_of(sources_);
  for (const auto& thread : threads_)
    for (const ThreadTiming::Component& component : thread->components()) {
      CellTable::Row row = {{name_in_graph(component.name, graph)},
                            {QString::fromStdString(thread->name())}};
      add_spread(component.steps, row);
      row.push_back(share_cell(component.steps.count() > 0 && thread->period() > 0.0
                                   ? component.steps.mean() / (1e9 * thread->period())
                                   : std::nan("")));
      row.push_back(count_cell(component.steps.count(), false));
      rows.push_back(std::move(row));
    }
  return rows;
}

}  // namespace trocar::gui
