// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace trocar {

/// y = A p + e with the least |e|.
struct LinearFit {
  std::vector<double> solution;  // p
  std::vector<double> errors;    // standard error of each, for e white and equally large everywhere
  double rms = 0.0;              // of e
  double r2 = 0.0;               // 1 - |e|^2 / |y - mean y|^2
};

/// Linear least squares by a QR decomposition with pivots. `columns` are those of A, each scaled to
/// length 1 beforehand, so that units do not matter.
/// @throw std::invalid_argument when lengths differ, rows are fewer than columns, or a column
/// depends on the others
LinearFit fit_linear(std::span<const std::vector<double>> columns, std::span<const double> target);

}  // namespace trocar
