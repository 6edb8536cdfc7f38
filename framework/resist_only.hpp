// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/realtime/rt_safe.hpp"
#include "framework/types.hpp"

namespace trocar {

/// What is left of a force that is no longer computed: it may only resist.
///
///   f·v > 0 at any time: 0 from then on;  else  f = f0 max(0, 1 - t / 10 ms)      [N]
class ResistOnly {
 public:
  static constexpr double decay_time = 0.010;  // [s]

  void begin(const Vector3& last_force) RT_SAFE {
    force_ = last_force;
    share_ = 1.0;
  }
  Vector3 step(const Vector3& velocity, double dt) RT_SAFE {
    share_ = share_ > dt / decay_time ? share_ - dt / decay_time : 0.0;
    if (!(force_.eigen().dot(velocity.eigen()) <= 0.0)) share_ = 0.0;
    return share_ > 0.0 ? Vector3(share_ * force_.eigen()) : Vector3();
  }

 private:
  Vector3 force_{};
  double share_ = 0.0;
};

}  // namespace trocar
