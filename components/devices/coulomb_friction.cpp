// SPDX-License-Identifier: Apache-2.0
#include "components/devices/coulomb_friction.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace trocar {
namespace {

double sign(double x) RT_SAFE {
  return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;
}

/// The solution if the axes kept sliding as `v` says, those at rest stuck.
Vector6d keep_sliding(const Matrix6d& A, const Vector6d& b, const Vector6d& limit,
                      const Vector6d& v) RT_SAFE {
  Matrix6d reduced = A;
  Vector6d right = b;
  for (int i = 0; i < 6; ++i) {
    right[i] -= limit[i] * sign(v[i]);
    if (v[i] != 0.0 || limit[i] == 0.0) continue;
    reduced.row(i).setZero();
    reduced.col(i).setZero();
    reduced(i, i) = 1.0;
    right[i] = 0.0;
  }
  return Eigen::LLT<Matrix6d>(reduced).solve(right);
}

/// Moves v to that solution, or as far as the first axis that comes to rest on the way.
/// @return whether v now obeys Coulomb in every axis
bool slide(const Matrix6d& A, const Vector6d& b, const Vector6d& limit, Vector6d& v) RT_SAFE {
  const Vector6d solution = keep_sliding(A, b, limit, v);
  double way = 1.0;
  int stops = -1;
  for (int i = 0; i < 6; ++i) {
    if (limit[i] == 0.0 || v[i] == 0.0 || solution[i] * v[i] > 0.0) continue;
    const double part = v[i] / (v[i] - solution[i]);
    if (stops >= 0 && part >= way) continue;
    way = part;
    stops = i;
  }
  if (stops >= 0) {
    v += way * (solution - v);
    v[stops] = 0.0;
    return false;
  }
  v = solution;
  for (int i = 0; i < 6; ++i)
    if (v[i] == 0.0 && limit[i] > 0.0 && !(std::abs(b[i] - A.row(i).dot(v)) <= limit[i]))
      return false;
  return true;
}

void sweep(const Matrix6d& A, const Vector6d& b, const Vector6d& limit, Vector6d& v) RT_SAFE {
  for (int i = 0; i < 6; ++i) {
    const double push = b[i] - A.row(i).dot(v) + A(i, i) * v[i];
    v[i] = sign(push) * std::max(0.0, std::abs(push) - limit[i]) / A(i, i);
  }
}

}  // namespace

int velocity_with_friction(const Matrix6d& A, const Vector6d& b, const Vector6d& limit,
                           Vector6d& v) RT_SAFE {
  if ((b.array().abs() <= limit.array()).all()) {
    v.setZero();
    return 0;
  }
  for (int sweeps = 0; sweeps < friction_sweeps; ++sweeps) {
    if (slide(A, b, limit, v)) return sweeps;
    sweep(A, b, limit, v);
  }
  return friction_sweeps;
}

}  // namespace trocar
