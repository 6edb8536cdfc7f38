// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <vector>

#include "gui/data/cell_table.hpp"
#include "gui/graph/graph_layout.hpp"
#include "gui/window/page.hpp"

namespace trocar::gui {

/// A graph and what goes on in it, as of the newest rows and events that are shown.
class GraphModel : public QObject {
  Q_OBJECT

 public:
  enum class State { waiting, running, faulted, ended, unknown };

  struct NodeLive {
    State state = State::waiting;
    QString fault{};          // its cause, until it is acknowledged
    double rate = 0.0;        // [Hz], 0: not known yet
    double step_mean = 0.0;   // [ns] of its newest ticks; NaN where it is not known
    double step_worst = 0.0;  // [ns] over the last second; NaN where it is not known
    double age = 0.0;         // [s] of its newest row behind the newest of all; NaN without rows
  };
  /// Of an edge to another thread.
  struct EdgeLive {
    bool known = false;
    bool valid = false;
    double age = 0.0;  // [s] of the value that is read
  };

  explicit GraphModel(const Sources& sources, QObject* parent = nullptr);

  const GraphStructure& structure() const { return structure_; }
  const GraphLayout& layout() const { return layout_; }
  const NodeLive& node(std::size_t index) const { return nodes_[index]; }
  const EdgeLive& edge(std::size_t index) const { return edges_[index]; }
  bool virtual_time() const { return virtual_time_; }

  void refresh();

  QString state_text(std::size_t node) const;   // "running", "FAULT: …"
  QString timing_text(std::size_t node) const;  // "1000 Hz   2.1 µs"
  /// All of it in words.
  QString description(std::size_t node) const;

  static QStringList port_header();
  std::vector<CellTable::Row> port_rows(std::size_t node) const;

 Q_SIGNALS:
  void structure_changed();

 private:
  void read_graph();
  void read_node(std::size_t index);
  void read_edge(std::size_t index);
  void read_faults();
  State state_of_run() const;
  QString value_text(const std::string& signal) const;

  Sources sources_;
  GraphStructure structure_;
  GraphLayout layout_;
  std::vector<NodeLive> nodes_;
  std::vector<EdgeLive> edges_;
  bool virtual_time_ = false;
};

const char* to_string(GraphModel::State state);

}  // namespace trocar::gui
