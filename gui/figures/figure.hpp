// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gui/figures/figure_sheet.hpp"
#include "gui/figures/force_deflection.hpp"
#include "gui/figures/result_file.hpp"

namespace trocar::gui {

/// What the command line says about a figure.
struct FigureOptions {
  RowFilter where{};       // of published rows
  int run = 1;             // of a log
  std::string thread{};    // of a log; "": the first
  std::string quantity{};  // of a workspace's map; "": what is usual
};

/// What was drawn, and its numbers in words.
struct DrawnFigure {
  std::unique_ptr<FigureSheet> sheet;
  std::string text;
};

/// A figure of an experiment. It throws FigureError when the file does not carry it.
struct FigureKind {
  const char* name;
  const char* shows;
  const char* takes;  // and what writes that
  DrawnFigure (*draw)(const ResultFile&, const FigureOptions&);
};

const std::vector<FigureKind>& figure_kinds();

inline constexpr double mm = 1e3;  // in a metre
QVector<double> in_mm(const std::vector<double>& metres);

DrawnFigure draw_force_deflection(const ResultFile& file, const FigureOptions& options);
DrawnFigure draw_chirp(const ResultFile& file, const FigureOptions& options);
DrawnFigure draw_workspace(const ResultFile& file, const FigureOptions& options);
DrawnFigure draw_lateness(const ResultFile& file, const FigureOptions& options);

}  // namespace trocar::gui
