// SPDX-License-Identifier: Apache-2.0
#include "gui/graph/graph_layers.hpp"

#include <algorithm>
#include <limits>

namespace trocar::gui {
namespace {

using Edges = std::vector<std::vector<std::size_t>>;  // readers of each node

bool leads_to(const Edges& readers, std::size_t from, std::size_t to, std::vector<bool>& seen) {
  if (from == to) return true;
  if (seen[from]) return false;
  seen[from] = true;
  return std::any_of(readers[from].begin(), readers[from].end(),
                     [&](std::size_t next) { return leads_to(readers, next, to, seen); });
}

/// Wires of the same tick lead forwards wherever they can; the others give way to them.
Edges without_loops(const GraphStructure& structure, std::vector<bool>& back) {
  Edges readers(structure.nodes.size());
  for (const auto line : {GraphStructure::Line::same_tick, GraphStructure::Line::other_thread,
                          GraphStructure::Line::later_tick})
    for (std::size_t i = 0; i < structure.edges.size(); ++i) {
      const GraphStructure::Edge& edge = structure.edges[i];
      if (edge.line != line) continue;
      std::vector<bool> seen(structure.nodes.size(), false);
      back[i] = leads_to(readers, edge.to, edge.from, seen);
      if (!back[i]) readers[edge.from].push_back(edge.to);
    }
  return readers;
}

int depth_of(const Edges& sources, std::size_t node, std::vector<int>& layer) {
  if (layer[node] >= 0) return layer[node];
  int deepest = 0;
  for (const std::size_t source : sources[node])
    deepest = std::max(deepest, depth_of(sources, source, layer) + 1);
  return layer[node] = deepest;
}

/// What reads nothing stands beside its first reader rather than far to the left of it.
void pull_beginnings(const Edges& readers, const Edges& sources, std::vector<int>& layer) {
  for (std::size_t node = 0; node < layer.size(); ++node) {
    if (!sources[node].empty() || readers[node].empty()) continue;
    int nearest = std::numeric_limits<int>::max();
    for (const std::size_t reader : readers[node]) nearest = std::min(nearest, layer[reader]);
    layer[node] = nearest - 1;
  }
}

}  // namespace

GraphLayers GraphLayers::of(const GraphStructure& structure) {
  GraphLayers layers{std::vector<int>(structure.nodes.size(), -1),
                     std::vector<bool>(structure.edges.size(), false)};
  const Edges readers = without_loops(structure, layers.back);
  Edges sources(structure.nodes.size());
  for (std::size_t node = 0; node < readers.size(); ++node)
    for (const std::size_t reader : readers[node]) sources[reader].push_back(node);
  for (std::size_t node = 0; node < readers.size(); ++node) depth_of(sources, node, layers.layer);
  pull_beginnings(readers, sources, layers.layer);
  return layers;
}

}  // namespace trocar::gui
