// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "gui/figures/chirp_tracking.hpp"
#include "gui/figures/figure.hpp"

namespace trocar::gui {
namespace {

void draw(FigureSheet& sheet, QCPAxisRect& panel, const ChirpTracking& chirp,
          const std::vector<double>& values, std::size_t number, const QString& name) {
  QCPGraph& graph = sheet.add_curve(panel);
  graph.setData({chirp.time.begin(), chirp.time.end()}, in_mm(values), true);
  graph.setPen(FigureSheet::curve(number));
  graph.setName(name);
}

}  // namespace

DrawnFigure draw_chirp(const ResultFile& file, const FigureOptions& options) {
  const ChirpTracking chirp = chirp_tracking(file, options.run, options.thread);
  const QString axis = QString::fromStdString(chirp.axis);
  auto sheet = std::make_unique<FigureSheet>(75.0);
  QCPAxisRect& motion = sheet->add_panel("Time [s]", axis + " [mm]", 1.5);
  QCPAxisRect& rest = sheet->add_panel("Time [s]", "Error [mm]", 1.0);
  FigureSheet::share_x_axis(motion);
  draw(*sheet, motion, chirp, chirp.reference, 0, "reference");
  draw(*sheet, motion, chirp, chirp.tip, 1, "tip");
  draw(*sheet, rest, chirp, chirp.error, 0, {});
  for (QCPAxisRect* panel : {&motion, &rest}) {
    panel->axis(QCPAxis::atBottom)->setRange(chirp.time.front(), chirp.time.back());
    panel->axis(QCPAxis::atLeft)->rescale();
    panel->axis(QCPAxis::atLeft)->scaleRange(1.15);
  }
  QCPAxis* y = motion.axis(QCPAxis::atLeft);
  y->setRangeUpper(y->range().upper + 0.3 * y->range().size());
  sheet->add_legend(motion, Qt::AlignTop | Qt::AlignLeft);
  return {std::move(sheet), tracking_text(chirp) + "\n"};
}

}  // namespace trocar::gui
