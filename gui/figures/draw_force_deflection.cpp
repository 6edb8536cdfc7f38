// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/text.hpp"
#include "gui/figures/figure.hpp"

namespace trocar::gui {
namespace {

QVector<double> list_of(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

QString legend_text(const ForceDeflection& curve) {
  return QString::fromStdString(
      fmt::format("{}: F = {:.2f} N/mm x {} {:.2f} N, R² {:.4f}", curve.label, curve.slope / mm,
                  curve.intercept < 0.0 ? "−" : "+", std::abs(curve.intercept), curve.r2));
}

void draw_curve(FigureSheet& sheet, QCPAxisRect& forces, QCPAxisRect& residuals,
                const ForceDeflection& curve, std::size_t number) {
  const auto [least, greatest] =
      std::minmax_element(curve.deflection.begin(), curve.deflection.end());
  QCPGraph& fit = sheet.add_curve(forces);
  fit.setData({mm * *least, mm * *greatest},
              {curve.slope * *least + curve.intercept, curve.slope * *greatest + curve.intercept});
  fit.setPen(FigureSheet::curve(number));
  QCPGraph& readings = sheet.add_curve(forces);
  readings.setData(in_mm(curve.deflection), list_of(curve.force));
  readings.setLineStyle(QCPGraph::lsNone);
  readings.setScatterStyle(FigureSheet::mark(number));
  readings.setName(legend_text(curve));
  QCPGraph& rest = sheet.add_curve(residuals);
  rest.setData(in_mm(curve.deflection), list_of(curve.residual));
  rest.setLineStyle(QCPGraph::lsNone);
  rest.setScatterStyle(FigureSheet::mark(number));
}

void add_zero(FigureSheet& sheet, QCPAxisRect& panel) {
  QCPItemLine& zero = sheet.add_line(panel);
  for (QCPItemPosition* end : {zero.start, zero.end})
    end->setTypeX(QCPItemPosition::ptAxisRectRatio);
  zero.start->setCoords(0.0, 0.0);
  zero.end->setCoords(1.0, 0.0);
}

/// Room above for the legend, and a little everywhere.
void set_ranges(QCPAxisRect& panel, double above) {
  for (QCPAxis* axis : {panel.axis(QCPAxis::atBottom), panel.axis(QCPAxis::atLeft)}) {
    axis->rescale();
    axis->scaleRange(axis->orientation() == Qt::Horizontal ? 1.08 : 1.2);
  }
  QCPAxis* axis = panel.axis(QCPAxis::atLeft);
  axis->setRangeUpper(axis->range().upper + above * axis->range().size());
}

std::string text_of(const ForceDeflections& all) {
  std::vector<std::string> shown, lines;
  for (const auto& [key, value] : all.shown) shown.push_back(key + "=" + value);
  lines.push_back(fmt::format("{}: {} of {} rows{}{}", all.source, all.curves.size(), all.rows,
                              shown.empty() ? "" : ", those with ", join(shown, ", ")));
  for (const ForceDeflection& curve : all.curves) lines.push_back("  " + fit_text(curve));
  return join(lines, "\n") + "\n";
}

}  // namespace

DrawnFigure draw_force_deflection(const ResultFile& file, const FigureOptions& options) {
  const ForceDeflections all = force_deflections(file, options.where);
  auto sheet = std::make_unique<FigureSheet>(88.0);
  QCPAxisRect& forces = sheet->add_panel("Deflection [mm]", "Force [N]", 2.4);
  QCPAxisRect& residuals = sheet->add_panel("Deflection [mm]", "Residual [N]", 1.0);
  FigureSheet::share_x_axis(forces);
  add_zero(*sheet, residuals);
  for (std::size_t i = 0; i < all.curves.size(); ++i)
    draw_curve(*sheet, forces, residuals, all.curves[i], i);
  set_ranges(forces, 0.075 * static_cast<double>(all.curves.size()));
  set_ranges(residuals, 0.0);
  residuals.axis(QCPAxis::atLeft)->ticker()->setTickCount(4);
  sheet->add_legend(forces, Qt::AlignTop | Qt::AlignLeft);
  return {std::move(sheet), text_of(all)};
}

}  // namespace trocar::gui
