// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "framework/realtime/rt_safe.hpp"
#include "framework/types.hpp"

namespace trocar {

/// The gate's own velocity, from the device's reports alone: the slope over the last five of them,
///
///   v_k = (q_k - q_{k-4}) / (t_k - t_{k-4})      [m/s or rad/s], late by half that time.
class AxisVelocity {
 public:
  /// As if it had rested here for four periods. @param time [s]
  void reset(const Joints& position, double time, double period) RT_SAFE {
    past_.fill({position, time});
    for (std::size_t i = 0; i < past_.size(); ++i)
      past_[(newest_ + past_.size() - i) % past_.size()].time =
          time - static_cast<double>(i + 1) * period;
    value_ = {};
  }
  void update(const Joints& position, double time) RT_SAFE {
    newest_ = (newest_ + 1) % past_.size();
    past_[newest_] = {position, time};
    const Report& oldest = past_[(newest_ + 1) % past_.size()];
    for (int i = 0; i < max_axes; ++i)
      value_[i] = (position[i] - oldest.position[i]) / (time - oldest.time);
  }
  const Joints& value() const RT_SAFE { return value_; }

 private:
  struct Report {
    Joints position{};
    double time = 0.0;  // [s]
  };
  std::array<Report, 5> past_{};
  std::size_t newest_ = 0;
  Joints value_{};
};

}  // namespace trocar
