// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/axis_scale.hpp"

#include <algorithm>
#include <cmath>

namespace trocar::hid {
namespace {

int rounded(double counts) RT_SAFE {
  if (!std::isfinite(counts)) return 0;
  return static_cast<int>(std::clamp(std::round(counts), -1.0 * effort_max, 1.0 * effort_max));
}

}  // namespace

AxisScale::AxisScale(const LimitsPage& limits, const CalibrationPage& calibration) RT_SAFE {
  for (std::size_t i = 0; i < axes; ++i) {
    unit_[i] = static_cast<double>(calibration.unit[i]);
    offset_[i] = calibration.offset[i];
    effort_unit_[i] = static_cast<double>(limits.peak[i]) / effort_max;
    effort_counts_[i] = effort_max / static_cast<double>(limits.peak[i]);
  }
}

Joints AxisScale::position(const PerAxis<std::int32_t>& encoder) const RT_SAFE {
  Joints result;
  for (std::size_t i = 0; i < axes; ++i)
    result.axis[i] = unit_[i] * (static_cast<double>(encoder[i]) - offset_[i]);
  return result;
}

Joints AxisScale::effort(const PerAxis<std::int16_t>& effort) const RT_SAFE {
  Joints result;
  for (std::size_t i = 0; i < axes; ++i) result.axis[i] = effort_unit_[i] * effort[i];
  return result;
}

void AxisScale::put(const Joints& hold, const Joints& total, CommandReport& command) const RT_SAFE {
  for (std::size_t i = 0; i < axes; ++i) {
    const int held = rounded(hold.axis[i] * effort_counts_[i]);
    const int all = rounded(total.axis[i] * effort_counts_[i]);
    const int effort = std::clamp<int>(all - held, -effort_max, effort_max);
    command.hold[i] = static_cast<std::int16_t>(all - effort);
    command.effort[i] = static_cast<std::int16_t>(effort);
  }
}

}  // namespace trocar::hid
