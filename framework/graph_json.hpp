// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "framework/wired_graph.hpp"

namespace trocar {

/// The graph for programs, and for a log: what ran, independent of the script. Its fields stand in
/// docs/log-format.md.
/// @param wired of the same graph: knows the types of generic ports and the values of parameters
///   that follow others; null where the graph is not sound
std::string graph_json(const Graph& graph, const WiredGraph* wired);

}  // namespace trocar
