// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gui/plots/custom_plot.hpp"
#include "gui/theme/theme.hpp"

namespace trocar::gui {

/// Axes and ground of a plot as the theme has them.
inline void set_plot_look(QCustomPlot& plot, const Theme& theme) {
  plot.setBackground(theme.surface);
  for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
    axis->setBasePen(QPen(theme.muted));
    axis->setTickPen(QPen(theme.muted));
    axis->setSubTickPen(QPen(theme.muted));
    axis->setTickLabelColor(theme.text);
    axis->setLabelColor(theme.text);
    axis->grid()->setPen(QPen(theme.grid));
    axis->grid()->setZeroLinePen(QPen(theme.muted));
  }
  plot.legend->setBrush(theme.surface);
  plot.legend->setBorderPen(QPen(theme.grid));
  plot.legend->setTextColor(theme.text);
}

}  // namespace trocar::gui
