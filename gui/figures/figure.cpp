// SPDX-License-Identifier: Apache-2.0
#include "gui/figures/figure.hpp"

namespace trocar::gui {

const std::vector<FigureKind>& figure_kinds() {
  static const std::vector<FigureKind> kinds = {
      {"force-deflection", "measured stiffness: force over deflection, the fit and its residuals",
       "trocar run scripts/experiments/table1.lua --clock simulated --json IN.json",
       draw_force_deflection},
  };
  return kinds;
}

}  // namespace trocar::gui
