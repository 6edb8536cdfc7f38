// SPDX-License-Identifier: Apache-2.0
#include "framework/least_squares.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace trocar {
namespace {

constexpr double dependent = 1e-9;  // what is left of a column of length 1

Eigen::Map<const Eigen::VectorXd> view(std::span<const double> numbers) {
  return {numbers.data(), static_cast<Eigen::Index>(numbers.size())};
}

}  // namespace

LinearFit fit_linear(std::span<const std::vector<double>> columns, std::span<const double> target) {
  const auto rows = static_cast<Eigen::Index>(target.size());
  const auto count = static_cast<Eigen::Index>(columns.size());
  if (count == 0 || rows < count)
    throw std::invalid_argument(fmt::format(
        "least squares: {} rows for {} columns: needs at least one column, and as many rows", rows,
        count));
  Eigen::MatrixXd a(rows, count);
  Eigen::VectorXd length(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const std::vector<double>& column = columns[static_cast<std::size_t>(k)];
    if (column.size() != target.size())
      throw std::invalid_argument(fmt::format("least squares: column {} has {} rows, the target {}",
                                              k + 1, column.size(), target.size()));
    length[k] = view(column).norm();
    if (!(length[k] > 0.0))
      throw std::invalid_argument(fmt::format("least squares: column {} is all zero", k + 1));
    a.col(k) = view(column) / length[k];
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
  qr.setThreshold(dependent);
  if (qr.rank() < count)
    throw std::invalid_argument(
        fmt::format("least squares: column {} depends on the others: leave it out",
                    qr.colsPermutation().indices()[qr.rank()] + 1));
  const Eigen::VectorXd y = view(target);
  const Eigen::VectorXd scaled = qr.solve(y);
  const double residual = (y - a * scaled).squaredNorm();
  const double spread = (y.array() - y.mean()).matrix().squaredNorm();

  const Eigen::MatrixXd r = qr.matrixR().topLeftCorner(count, count);
  const Eigen::MatrixXd inverse = r.triangularView<Eigen::Upper>().solve(
      Eigen::MatrixXd(Eigen::MatrixXd::Identity(count, count)));
  const double variance = residual / static_cast<double>(std::max<Eigen::Index>(rows - count, 1));
  LinearFit fit{.solution = std::vector<double>(columns.size()),
                .errors = std::vector<double>(columns.size()),
                .rms = std::sqrt(residual / static_cast<double>(rows)),
                .r2 = spread > 0.0 ? 1.0 - residual / spread : 1.0};
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index column = qr.colsPermutation().indices()[k];
    const auto at = static_cast<std::size_t>(column);
    fit.solution[at] = scaled[column] / length[column];
    fit.errors[at] = std::sqrt(variance * inverse.row(k).squaredNorm()) / length[column];
  }
  return fit;
}

}  // namespace trocar
