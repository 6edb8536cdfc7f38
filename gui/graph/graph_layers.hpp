// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "gui/graph/graph_structure.hpp"

namespace trocar::gui {

/// Columns for the components of a graph: each stands right of all that it reads, but for the
/// wires that close a loop.
struct GraphLayers {
  std::vector<int> layer;  // of nodes, from 0
  std::vector<bool> back;  // of edges: leads to the left, or stays

  static GraphLayers of(const GraphStructure& structure);
};

}  // namespace trocar::gui
