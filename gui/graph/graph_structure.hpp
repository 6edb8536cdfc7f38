// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace trocar::gui {

/// Components, groups and wires of a graph, as its description says (docs/log-format.md#graphjson).
struct GraphStructure {
  struct Port {
    std::string name;  // "tip"
    std::string type, unit, frame, doc;
    bool input = false;
    std::vector<std::string> connected;  // of an input: sources; of an output: readers
  };
  struct Node {
    std::string name;  // "laparoscope.device"
    std::string type, doc, thread;
    std::optional<std::size_t> group;  // of groups
    bool device = false;
    double rate = 0.0;  // [Hz] of its own or of its thread; 0: that of the run
    std::vector<Port> ports{};
  };
  struct Group {
    std::string name, type;
    std::optional<std::size_t> outer;  // of groups
  };
  /// When a value is read: in the tick that wrote it, in a later one, or by another thread.
  enum class Line { same_tick, later_tick, other_thread };
  /// All wires of one kind from one component to another.
  struct Edge {
    std::size_t from = 0, to = 0;  // of nodes
    Line line = Line::same_tick;
    QStringList wires{};                // "tip.position → position"
    std::vector<std::string> inputs{};  // that are fed: "wall.offset"
    double stale = 0.0;                 // [s] age at which a value from another thread is too old
  };

  std::vector<Node> nodes{};
  std::vector<Group> groups{};
  std::vector<Edge> edges{};
  std::size_t threads = 0;  // that have components

  static GraphStructure of(const nlohmann::json& graph);
  std::optional<std::size_t> find(const std::string& node) const;
  /// Group and name within it: "device" in "laparoscope".
  QString title(std::size_t node) const;
};

}  // namespace trocar::gui
