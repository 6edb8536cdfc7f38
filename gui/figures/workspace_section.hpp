// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gui/figures/result_file.hpp"

namespace trocar::gui {

/// Cells of the map of a workspace that lie in a plane.
struct WorkspaceSection {
  struct Cell {
    double across = 0.0, up = 0.0;  // of its centre [m]
    double value = 0.0;             // NaN where no pose was found
  };
  double at = 0.0;  // of the plane [m]
  std::vector<Cell> cells;
};

/// Two sections through a map that `trocar workspace --csv` wrote.
struct WorkspaceSections {
  WorkspaceSection side;               // x and z, beside y = 0
  WorkspaceSection top;                // x and y, where most is reached
  double edge = 0.0;                   // of a cell [m]
  double least = 0.0, greatest = 0.0;  // of the values in both
  std::string quantity;                // the column
};

/// @param quantity a column of the table
/// @throw FigureError when it is no such map, or has not that column
WorkspaceSections workspace_sections(const ResultFile& file, const std::string& quantity);

/// "Continuous force, least [N]".
std::string quantity_text(const std::string& column);

}  // namespace trocar::gui
