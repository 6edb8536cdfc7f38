// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/command_report.hpp"
#include "components/devices/hid/page_report.hpp"
#include "framework/types.hpp"

namespace trocar::hid {

/// Between the protocol's counts and SI, from the device's own pages.
///
///   position_i = unit_i (count_i - offset_i)  [m, rad],   effort_i = peak_i n_i / 32767  [N, N m]
class AxisScale {
 public:
  AxisScale(const LimitsPage& limits, const CalibrationPage& calibration) RT_SAFE;

  Joints position(const PerAxis<std::int32_t>& encoder) const RT_SAFE;
  Joints effort(const PerAxis<std::int16_t>& effort) const RT_SAFE;

  /// Writes hold, and total - hold as effort. Their sum is the rounded total, within the peak;
  /// where the difference is beyond the peak, hold makes up for it. What is not finite becomes 0.
  /// @param total [N, N m] hold included
  void put(const Joints& hold, const Joints& total, CommandReport& command) const RT_SAFE;

 private:
  PerAxis<double> unit_, offset_, effort_unit_, effort_counts_;
};

}  // namespace trocar::hid
