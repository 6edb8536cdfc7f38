// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "framework/command.hpp"
#include "framework/wired_graph.hpp"

namespace trocar {

/// A change of a parameter while the graph runs.
struct Edit {
  double at = 0.0;  // [s]
  std::string key;  // "wall.stiffness"
  Literal value;
  Where where;
};

/// The edits of a run as commands to the thread that each parameter belongs to. An edit of a
/// parameter that others follow moves all of them.
/// @return for each group of the wired graph
/// @throw BrokenGraph with every edit that cannot be
std::vector<std::vector<Command>> schedule_edits(const std::vector<Edit>& edits, const Graph& graph,
                                                 const WiredGraph& wired);

}  // namespace trocar
