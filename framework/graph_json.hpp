// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "framework/graph.hpp"

namespace trocar {

/// The graph with every parameter's value, for a log: what ran, independent of the script.
std::string graph_json(const Graph& graph);

}  // namespace trocar
