// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/motion_monitor.hpp"

#include <cmath>

namespace trocar::hid {

MotionMonitor::MotionMonitor(const PerAxis<double>& speed) : speed_(speed) {}

void MotionMonitor::update(const PerAxis<std::int32_t>& encoder, std::uint32_t elapsed_us,
                           std::uint8_t preset) RT_SAFE {
  jumped_ = false;
  if (!started_) {
    last_ = window_start_ = encoder;
    started_ = true;
    return;
  }
  const double elapsed = elapsed_us * 1e-6;
  for (std::size_t i = 0; i < axes; ++i) {
    const double moved = static_cast<double>(encoder[i]) - last_[i];
    if ((preset >> i & 1) != 0)
      window_start_[i] = static_cast<std::int32_t>(encoder[i] - (last_[i] - window_start_[i]));
    else if (std::abs(moved) > 2.0 * speed_[i] * elapsed + 1.0)
      jumped_ = true;
  }
  last_ = encoder;
  window_us_ += elapsed_us;
  if (window_us_ < window_us) return;
  const double per_second = 1e6 / window_us_;
  for (std::size_t i = 0; i < axes; ++i)
    measured_[i] = std::abs(static_cast<double>(encoder[i]) - window_start_[i]) * per_second;
  window_start_ = encoder;
  window_us_ = 0;
}

bool MotionMonitor::faster_than(const PerAxis<double>& speed) const RT_SAFE {
  for (std::size_t i = 0; i < axes; ++i)
    if (measured_[i] > speed[i]) return true;
  return false;
}

}  // namespace trocar::hid
