// SPDX-License-Identifier: Apache-2.0
#include "gui/graph/graph_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gui/data/shown_number.hpp"
#include "gui/graph/graph_reading.hpp"
#include "gui/playback/log_feed.hpp"

namespace trocar::gui {
namespace {

constexpr double unknown_time = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t rows_of_mean = 256;
constexpr double worst_window = 1.0;     // [s] of the worst step and the rate
constexpr std::size_t most_numbers = 8;  // of a port that are written out

std::string step_signal(std::string node) {
  std::replace(node.begin(), node.end(), '.', '_');
  return "step_times." + node;
}

double mean_of(const Column& column, std::uint64_t begin, std::uint64_t end) {
  double sum = 0.0, count = 0.0;
  for (std::uint64_t row = std::max(begin, end > rows_of_mean ? end - rows_of_mean : 0); row < end;
       ++row) {
    if (!(column[row] > 0.0)) continue;  // it was not due
    sum += column[row];
    count += 1.0;
  }
  return count > 0.0 ? sum / count : unknown_time;
}

}  // namespace

const char* to_string(GraphModel::State state) {
  switch (state) {
    case GraphModel::State::waiting:
      return "no rows yet";
    case GraphModel::State::running:
      return "running";
    case GraphModel::State::faulted:
      return "FAULT";
    case GraphModel::State::ended:
      return "run ended";
    case GraphModel::State::unknown:
      return "UNKNOWN, no link";
  }
  return "?";
}

GraphModel::GraphModel(const Sources& sources, QObject* parent)
    : QObject(parent), sources_(sources) {
  if (sources_.live != nullptr)
    connect(sources_.live, &LiveFeed::graph_known, this, &GraphModel::read_graph);
  if (sources_.log != nullptr)
    connect(sources_.log, &LogFeed::opened, this, &GraphModel::read_graph);
  read_graph();
}

void GraphModel::read_graph() {
  structure_ = GraphStructure::of(graph_of(sources_));
  layout_ = GraphLayout::of(structure_);
  nodes_.assign(structure_.nodes.size(), {});
  edges_.assign(structure_.edges.size(), {});
  refresh();
  Q_EMIT structure_changed();
}

GraphModel::State GraphModel::state_of_run() const {
  if (sources_.link != nullptr && sources_.link->state() != LinkState::open) return State::unknown;
  if (sources_.live != nullptr && !sources_.live->state().running) return State::ended;
  return State::running;
}

void GraphModel::refresh() {
  virtual_time_ = sources_.live != nullptr && sources_.live->state().virtual_time;
  for (std::size_t i = 0; i < nodes_.size(); ++i) read_node(i);
  for (std::size_t i = 0; i < edges_.size(); ++i) read_edge(i);
  read_faults();
}

void GraphModel::read_node(std::size_t index) {
  const GraphStructure::Node& node = structure_.nodes[index];
  NodeLive live{.rate = node.rate,
                .step_mean = unknown_time,
                .step_worst = unknown_time,
                .age = unknown_time};
  const Track* track = sources_.data.track(node.thread);
  const std::uint64_t end = track == nullptr ? 0 : track->view_end();
  if (end > (track == nullptr ? 0 : track->first())) {
    live.state = state_of_run();
    const double newest = track->time(end - 1);
    live.age = std::max(0.0, sources_.data.now() - newest);
    const std::uint64_t begin = track->at(newest - worst_window);
    const double span = newest - track->time(begin);
    if (!(live.rate > 0.0) && span > 0.0) live.rate = static_cast<double>(end - 1 - begin) / span;
    if (const auto column = track->find(step_signal(node.name))) {
      const Extremes steps = track->column(*column).extremes(begin, end);
      if (steps.max > 0.0) {
        live.step_worst = steps.max;
        live.step_mean = mean_of(track->column(*column), begin, end);
      }
    }
  }
  nodes_[index] = std::move(live);
}

/// The reader's rows say of which tick of the writer's thread the value is.
void GraphModel::read_edge(std::size_t index) {
  const GraphStructure::Edge& edge = structure_.edges[index];
  EdgeLive& live = edges_[index];
  live = {};
  if (edge.line != GraphStructure::Line::other_thread) return;
  const Track* writer = sources_.data.track(structure_.nodes[edge.from].thread);
  if (writer == nullptr || writer->end() < writer->first() + 2) return;
  for (const std::string& input : edge.inputs) {
    const auto tick = sources_.data.find(input + "_tick");
    const auto valid = sources_.data.find(input + "_valid");
    if (!tick || !valid || !std::isfinite(tick->last())) continue;
    const std::uint64_t first = writer->first(), last = writer->end() - 1;
    const double ticks = static_cast<double>(writer->tick(last) - writer->tick(first));
    const double period = ticks > 0 ? (writer->time(last) - writer->time(first)) / ticks : 0.0;
    const double written =
        writer->time(first) + period * (tick->last() - static_cast<double>(writer->tick(first)));
    const std::uint64_t now = tick->track->view_end() - 1;
    live.valid = (live.valid || !live.known) && valid->last() > 0.5;
    live.age = std::max(live.age, tick->track->time(now) - written);
    live.known = true;
  }
}

void GraphModel::read_faults() {
  const std::size_t shown = sources_.data.events_shown();
  for (std::size_t i = 0; i < shown; ++i) {
    const RunEvent& event = sources_.data.events()[i];
    if (event.kind == "acknowledged")
      for (NodeLive& node : nodes_) node.fault.clear();
    if (event.kind != "fault") continue;
    if (const auto node = structure_.find(event.source))
      if (nodes_[*node].fault.isEmpty()) nodes_[*node].fault = QString::fromStdString(event.detail);
  }
  for (NodeLive& node : nodes_)
    if (!node.fault.isEmpty() && node.state == State::running) node.state = State::faulted;
}

QString GraphModel::state_text(std::size_t node) const {
  const NodeLive& live = nodes_[node];
  const QString text = to_string(live.state);
  return live.fault.isEmpty() ? text : text + ": " + live.fault;
}

QString GraphModel::timing_text(std::size_t node) const {
  const NodeLive& live = nodes_[node];
  QStringList parts;
  if (live.rate > 0.0) parts << QString("%1 Hz").arg(live.rate, 0, 'g', 5);
  if (!std::isnan(live.step_mean)) parts << shown_duration(live.step_mean);
  if (live.age > 0.5) parts << QString("%1 s old").arg(live.age, 0, 'f', 1);
  return parts.join("   ");
}

QString GraphModel::description(std::size_t node) const {
  const GraphStructure::Node& one = structure_.nodes[node];
  const NodeLive& live = nodes_[node];
  QStringList parts = {QString::fromStdString(one.name + ", a " + one.type), state_text(node)};
  if (live.rate > 0.0) parts << QString("%1 Hz").arg(live.rate, 0, 'g', 5);
  if (!std::isnan(live.step_mean))
    parts << "one tick " + shown_duration(live.step_mean) + ", at most " +
                 shown_duration(live.step_worst) + " in the last second";
  if (!std::isnan(live.age)) parts << "newest row " + shown_number(live.age, "s") + " old";
  for (std::size_t i = 0; i < edges_.size(); ++i)
    if (structure_.edges[i].to == node && edges_[i].known)
      parts << QString("%1 from another thread: %2, %3 old")
                   .arg(structure_.edges[i].wires.join(", "), edges_[i].valid ? "valid" : "LOST",
                        shown_number(edges_[i].age, "s"));
  return parts.join("; ");
}

QStringList GraphModel::port_header() {
  return {"", "port", "value", "wired to", "type", "unit"};
}

std::vector<CellTable::Row> GraphModel::port_rows(std::size_t node) const {
  std::vector<CellTable::Row> rows;
  const GraphStructure::Node& one = structure_.nodes[node];
  for (const GraphStructure::Port& port : one.ports) {
    const std::string own = one.name + "." + port.name;
    QString value = value_text(own);  // inputs from other threads are in the rows too
    if (value.isEmpty() && port.input && port.connected.size() == 1)
      value = value_text(port.connected.front());
    QStringList others;
    for (const std::string& other : port.connected) others << QString::fromStdString(other);
    rows.push_back({{port.input ? "in" : "out"},
                    {QString::fromStdString(port.name)},
                    {value.isEmpty() ? "–" : value},
                    {others.isEmpty() ? "–" : others.join(", ")},
                    {QString::fromStdString(port.type)},
                    {QString::fromStdString(port.unit)}});
  }
  return rows;
}

/// All numbers of a port, or of a part of one, that are in the rows, each unit once after those
/// that have it; "" where none is.
QString GraphModel::value_text(const std::string& signal) const {
  for (const std::unique_ptr<Track>& track : sources_.data.tracks()) {
    QStringList texts, values;
    std::string unit;
    std::size_t count = 0;
    const auto end_unit = [&] {
      if (!values.isEmpty()) texts << (values.join(", ") + " " + shown_unit(unit)).trimmed();
      values.clear();
    };
    for (std::size_t i = 0; i < track->signal_list().size(); ++i) {
      const SchemaSignal& leaf = track->signal_list()[i];
      if (leaf.name != signal && !leaf.name.starts_with(signal + ".")) continue;
      if (++count > most_numbers) continue;
      if (leaf.unit != unit) end_unit();
      unit = leaf.unit;
      values << shown_value(SignalRef{track.get(), i}.last(), unit);
    }
    end_unit();
    if (count > most_numbers) return QString("%1 numbers").arg(count);
    if (count > 0) return texts.join("; ");
  }
  return "";
}

}  // namespace trocar::gui
