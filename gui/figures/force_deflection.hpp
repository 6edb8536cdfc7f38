// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "framework/least_squares.hpp"
#include "gui/figures/result_file.hpp"

namespace trocar::gui {

/// Which published rows are drawn: "seed" → "2". A number matches by its value.
using RowFilter = std::map<std::string, std::string>;

/// A stiffness as measured: force over deflection, and the line F = slope x + intercept through it
/// by least squares, as the experiment fits it.
struct ForceDeflection {
  std::string label;               // "x, 5 N/mm"
  std::vector<double> deflection;  // [m]
  std::vector<double> force;       // [N]
  std::vector<double> residual;    // of the force [N]
  double slope = 0.0;              // [N/m]
  double slope_error = 0.0;        // standard error [N/m]
  double intercept = 0.0;          // [N]
  double rms = 0.0;                // of the residuals [N]
  double r2 = 0.0;
  double reported = 0.0;  // slope that was published with the readings [N/m]; NaN: none
};

struct ForceDeflections {
  std::string source;  // the name that they are published under
  std::vector<ForceDeflection> curves;
  RowFilter shown;       // what they have in common
  std::size_t rows = 0;  // that were published, of all devices and settings
};

inline constexpr std::size_t most_curves = 6;

/// Of published rows with the lists `x` [m] and `force` [N], as table1.lua publishes them. What
/// `filter` leaves open is as in the first row that fits, but for axis and desired stiffness.
/// @throw FigureError when there are none, or more than a figure can show
ForceDeflections force_deflections(const ResultFile& file, const RowFilter& filter);

/// "x, 5 N/mm: 4.902 ± 0.012 N/mm, -0.03 N, R² 0.99012, residual 0.41 N RMS, 17 readings".
std::string fit_text(const ForceDeflection& curve);

}  // namespace trocar::gui
