// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_dexterity.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <string>

#include "components/requirement.hpp"

namespace trocar {
namespace {

constexpr double turning_length = 0.1;  // [m]

void require_effort(const char* name, double value, const char* unit) {
  require(value >= 0.0 && std::isfinite(value), std::string("efforts: ") + name, value,
          std::string("needs at least 0 ") + unit);
}

double worst_force(const LaparoscopeRates& rates, const Vector6d& spare) {
  double force = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < 6; ++i)
    force = std::min(force, spare[i] / rates.jacobian.col(i).head<3>().norm());
  return force;
}

}  // namespace

Vector6d LaparoscopeEfforts::peak() const {
  return (Vector6d() << slider_peak, slider_peak, slider_peak, ring_peak, ring_peak, ring_peak)
      .finished();
}

Vector6d LaparoscopeEfforts::continuous() const {
  return (Vector6d() << slider_continuous, slider_continuous, slider_continuous, ring_continuous,
          ring_continuous, ring_continuous)
      .finished();
}

void validate(const LaparoscopeEfforts& efforts) {
  require_effort("slider_peak", efforts.slider_peak, "N");
  require_effort("slider_continuous", efforts.slider_continuous, "N");
  require_effort("ring_peak", efforts.ring_peak, "N m");
  require_effort("ring_continuous", efforts.ring_continuous, "N m");
}

Dexterity dexterity(const LaparoscopeRates& rates, double ring_radius, const Vector6d& peak,
                    const Vector6d& continuous) {
  Matrix6d scaled = rates.jacobian;
  scaled.bottomRows<3>() *= turning_length;
  scaled.rightCols<3>() /= ring_radius;
  const Matrix6d square = scaled * scaled.transpose();
  const Vector6d squares =
      Eigen::SelfAdjointEigenSolver<Matrix6d>(square, Eigen::EigenvaluesOnly).eigenvalues();
  return {.condition = std::sqrt(squares[5] / std::max(squares[0], 0.0)),
          .manipulability = std::abs(scaled.determinant()),
          .peak_force = worst_force(rates, peak),
          .continuous_force = worst_force(rates, continuous)};
}

double force_along(const LaparoscopeRates& rates, const Eigen::Vector3d& direction,
                   const Vector6d& spare) {
  const Vector6d taken = (rates.jacobian.topRows<3>().transpose() * direction).cwiseAbs();
  return (spare.array() / taken.array()).minCoeff();
}

}  // namespace trocar
