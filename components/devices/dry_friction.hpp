// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "components/kinematics/matrices.hpp"
#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// How strong dry friction can be at a speed (Stribeck's curve, in the exponential form of Bo and
/// Pavelescu 1982):
///
///   f(v) = F_c (1 + (s - 1) exp(-(v / v_s)^2)),   s = F_s / F_c
///
/// With s = 1 it is Coulomb's. A velocity-independent direction and sticking are the solver's
/// (coulomb_friction.hpp).
class DryFriction {
 public:
  /// @param coulomb F_c [N, N m], >= 0  @param ratio s >= 1  @param speed v_s [m/s, rad/s], > 0
  DryFriction(const Vector6d& coulomb, double ratio, const Vector6d& speed)
      : coulomb_(coulomb),
        excess_((ratio - 1.0) * coulomb),
        slowness_(speed.cwiseInverse()),
        falls_(ratio > 1.0) {}

  /// [N, N m]
  Vector6d limit(const Vector6d& velocity) const RT_SAFE {
    if (!falls_) return coulomb_;
    Vector6d limit = coulomb_;
    for (int i = 0; i < 6; ++i) {
      const double speeds = velocity[i] * slowness_[i];
      const double square = speeds * speeds;
      if (square < negligible) limit[i] += excess_[i] * std::exp(-square);
    }
    return limit;
  }

 private:
  static constexpr double negligible = 40.0;  // exp(-40) changes no digit of a double

  Vector6d coulomb_, excess_, slowness_;
  bool falls_;
};

}  // namespace trocar
