// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "framework/realtime/rt_safe.hpp"
#include "framework/types.hpp"

namespace trocar {

/// The gate's own velocity, from the device's reports alone: the slope over the last five of them,
///
///   v_k = (q_k - q_{k-4}) / (4 T)      [m/s or rad/s], late by 2 T.
class AxisVelocity {
 public:
  explicit AxisVelocity(double period) : period_(period) {}

  void reset(const Joints& position) RT_SAFE {
    past_.fill(position);
    value_ = {};
  }
  void update(const Joints& position) RT_SAFE {
    newest_ = (newest_ + 1) % past_.size();
    past_[newest_] = position;
    const Joints& oldest = past_[(newest_ + 1) % past_.size()];
    for (int i = 0; i < max_axes; ++i) value_[i] = (position[i] - oldest[i]) / (4.0 * period_);
  }
  const Joints& value() const RT_SAFE { return value_; }

 private:
  double period_;
  std::array<Joints, 5> past_{};
  std::size_t newest_ = 0;
  Joints value_{};
};

}  // namespace trocar
