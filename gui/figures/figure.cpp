// SPDX-License-Identifier: Apache-2.0
#include "gui/figures/figure.hpp"

namespace trocar::gui {

const std::vector<FigureKind>& figure_kinds() {
  static const std::vector<FigureKind> kinds = {
      {"force-deflection", "measured stiffness: force over deflection, the fit and its residuals",
       "trocar run scripts/experiments/table1.lua --clock simulated --json IN.json",
       draw_force_deflection},
      {"chirp", "trajectory tracking: reference and tip over time, and the error",
       "trocar run scripts/experiments/chirp.lua --clock simulated --set seeds=1 --record IN.mcap",
       draw_chirp},
      {"workspace", "sections through where the tip reaches, shaded by --quantity",
       "trocar workspace --csv IN.csv", draw_workspace},
      {"lateness", "histogram of how late ticks begin",
       "trocar run SCRIPT --record IN.mcap, in real time", draw_lateness},
  };
  return kinds;
}

QVector<double> in_mm(const std::vector<double>& metres) {
  QVector<double> list;
  for (const double value : metres) list.push_back(mm * value);
  return list;
}

}  // namespace trocar::gui
