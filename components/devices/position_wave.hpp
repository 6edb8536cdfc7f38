// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "components/kinematics/matrices.hpp"
#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// sin(2 pi turns) to 1e-9, of up to 1e9 turns: Taylor's series, from the nearest zero.
inline double sine_of_turns(double turns) RT_SAFE {
  constexpr double shift = 0x1.8p52;  // adding it rounds to a whole number
  double t = turns - ((turns + shift) - shift);
  if (std::abs(t) > 0.25) t = std::copysign(0.5, t) - t;
  const double x = 6.2831853071795865 * t;
  const double s = x * x;
  const double higher = 1.0 / 362880.0 - s * (1.0 / 39916800.0 - s * (1.0 / 6227020800.0));
  return x * (1.0 - s * (1.0 / 6.0 - s * (1.0 / 120.0 - s * (1.0 / 5040.0 - s * higher))));
}

/// What repeats along the way of each axis:
///
///   w_i = sin(2 pi (q_i / pitch_i + phase_i))
class PositionWave {
 public:
  /// @param pitch [m, rad], > 0  @param phase [turns]
  PositionWave(const Vector6d& pitch, const Vector6d& phase)
      : turns_(pitch.cwiseInverse()), phase_(phase) {}

  Vector6d at(const Vector6d& q) const RT_SAFE {
    Vector6d wave;
    for (int i = 0; i < 6; ++i) wave[i] = sine_of_turns(turns_[i] * q[i] + phase_[i]);
    return wave;
  }

 private:
  Vector6d turns_, phase_;  // [1/m, 1/rad], [1]
};

}  // namespace trocar
