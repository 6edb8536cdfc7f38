// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/report_bytes.hpp"

namespace trocar::hid {

/// Speed and jumps of the encoders, on the device.
///
///   jump:   |n_k - n_k-1| > 2 v_max (t_k - t_k-1) + 1 count
///   speed:  over windows of at least 8 ms, since one count a cycle says little
class MotionMonitor {
 public:
  static constexpr std::uint32_t window_us = 8'000;

  /// @param speed v_max of each axis [counts/s]
  explicit MotionMonitor(const PerAxis<double>& speed);

  /// @param elapsed_us since the last call
  /// @param preset bit i: the count of axis i was set anew, and says nothing of motion
  void update(const PerAxis<std::int32_t>& encoder, std::uint32_t elapsed_us,
              std::uint8_t preset) RT_SAFE;

  bool jumped() const RT_SAFE { return jumped_; }  // in the last update
  /// Whether an axis was faster, in the last complete window [counts/s].
  bool faster_than(const PerAxis<double>& speed) const RT_SAFE;
  bool too_fast() const RT_SAFE { return faster_than(speed_); }

 private:
  PerAxis<double> speed_;
  PerAxis<std::int32_t> last_{}, window_start_{};
  PerAxis<double> measured_{};  // [counts/s]
  std::uint32_t window_us_ = 0;
  bool started_ = false;
  bool jumped_ = false;
};

}  // namespace trocar::hid
