// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gui/figures/figure.hpp"
#include "gui/figures/workspace_section.hpp"

namespace trocar::gui {
namespace {

QCPColorGradient greys() {
  QCPColorGradient gradient;
  gradient.clearColorStops();
  gradient.setColorStopAt(0.0, QColor("#f2f2f2"));
  gradient.setColorStopAt(1.0, QColor("#303030"));
  return gradient;
}

/// Squares, so that vector files stay sharp; a cell without a pose is crossed out.
void draw_cells(FigureSheet& sheet, QCPAxisRect& panel, const WorkspaceSection& section,
                const WorkspaceSections& all) {
  QCPColorGradient gradient = greys();
  const double half = 0.5 * all.edge;
  for (const WorkspaceSection::Cell& cell : section.cells) {
    auto* square = new QCPItemRect(&sheet.plot());
    square->setClipAxisRect(&panel);
    for (QCPItemPosition* corner : {square->topLeft, square->bottomRight}) {
      corner->setAxisRect(&panel);
      corner->setAxes(panel.axis(QCPAxis::atBottom), panel.axis(QCPAxis::atLeft));
    }
    square->topLeft->setCoords(mm * (cell.across - half), mm * (cell.up + half));
    square->bottomRight->setCoords(mm * (cell.across + half), mm * (cell.up - half));
    square->setPen(FigureSheet::line(0.05, Qt::SolidLine, QColor("#909090")));
    square->setBrush(
        std::isfinite(cell.value)
            ? QBrush(QColor(gradient.color(cell.value, QCPRange(all.least, all.greatest))))
            : QBrush(QColor("#909090"), Qt::DiagCrossPattern));
  }
}

/// A millimetre is as long along both axes.
void set_ranges(QCPAxisRect& panel, const WorkspaceSection& section, double edge) {
  QCPRange across, up;
  for (const WorkspaceSection::Cell& cell : section.cells) {
    across.expand(QCPRange(mm * (cell.across - edge), mm * (cell.across + edge)));
    up.expand(QCPRange(mm * (cell.up - edge), mm * (cell.up + edge)));
  }
  QCPAxis *x = panel.axis(QCPAxis::atBottom), *y = panel.axis(QCPAxis::atLeft);
  const double per_pixel = std::max(across.size() / panel.width(), up.size() / panel.height());
  x->ticker()->setTickCount(3);
  x->setRange(across.center(), per_pixel * panel.width(), Qt::AlignCenter);
  y->setRange(up.center(), per_pixel * panel.height(), Qt::AlignCenter);
}

void add_scale(FigureSheet& sheet, const WorkspaceSections& all) {
  auto* scale = new QCPColorScale(&sheet.plot());
  scale->setType(QCPAxis::atBottom);
  scale->setBarWidth(25);
  scale->setGradient(greys());
  scale->setDataRange(QCPRange(all.least, all.greatest));
  scale->axis()->setLabel(QString::fromStdString(quantity_text(all.quantity)));
  scale->axis()->setLabelFont(FigureSheet::font());
  scale->axis()->setTickLabelFont(FigureSheet::font());
  scale->axis()->setTickPen(FigureSheet::line(0.2));
  scale->axis()->setSubTickPen(FigureSheet::line(0.15));
  scale->axis()->setBasePen(FigureSheet::line(0.2));
  QCPLayoutGrid* layout = sheet.plot().plotLayout();
  layout->addElement(layout->rowCount(), 0, scale);
  layout->setRowStretchFactor(layout->rowCount() - 1, 0.01);
}

}  // namespace

DrawnFigure draw_workspace(const ResultFile& file, const FigureOptions& options) {
  const WorkspaceSections all = workspace_sections(
      file, options.quantity.empty() ? "continuous_force_least" : options.quantity);
  auto sheet = std::make_unique<FigureSheet>(52.0);
  QCPAxisRect& side = sheet->add_panel("x [mm]", "z [mm]");
  QCPAxisRect& top = sheet->add_panel_beside("x [mm]", "y [mm]");
  add_scale(*sheet, all);
  draw_cells(*sheet, side, all.side, all);
  draw_cells(*sheet, top, all.top, all);
  sheet->plot().replot();  // the ranges need the panels' sizes
  set_ranges(side, all.side, all.edge);
  set_ranges(top, all.top, all.edge);
  return {std::move(sheet),
          fmt::format("{}: {:.4g} to {:.4g} in the sections y = {:.0f} mm (left) and z = {:.0f} mm "
                      "(right), by cells of {:.0f} mm\n",
                      quantity_text(all.quantity), all.least, all.greatest, mm * all.side.at,
                      mm * all.top.at, mm * all.edge)};
}

}  // namespace trocar::gui
