// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "gui/graph/graph_structure.hpp"

namespace trocar::gui {

/// Lanes from top to bottom for the components of a graph: one for each thread where there are
/// several, in those one for each group, in those for groups inside.
struct GraphLanes {
  struct Lane {
    QString title;
    bool is_thread = false;
    int depth = -1;                    // lanes around it, that of all left out
    std::size_t outer = 0;             // lane
    std::vector<std::size_t> inner{};  // lanes
  };
  std::vector<Lane> lanes{};           // the first is that of all
  std::vector<std::size_t> of_node{};  // the innermost lane of each node

  /// Whether `inner` is `lane`, or inside it.
  bool holds(std::size_t lane, std::size_t inner) const;
};

GraphLanes lanes_of(const GraphStructure& structure);

}  // namespace trocar::gui
