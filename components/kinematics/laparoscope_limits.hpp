// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "components/kinematics/laparoscope_model.hpp"

namespace trocar {

/// A set of limits that a configuration violates.
class LimitSet {
 public:
  enum Limit : unsigned {
    slider_1_low,
    slider_2_low,
    slider_3_low,
    slider_1_high,
    slider_2_high,
    slider_3_high,
    ring_1_low,
    ring_2_low,
    ring_3_low,
    ring_1_high,
    ring_2_high,
    ring_3_high,
    centre_offset,
    tilt,
    engagement_low,
    engagement_high,
    link_1_angle,
    link_2_angle,
    link_3_angle,
    count,
  };

  constexpr bool empty() const RT_SAFE { return bits_ == 0; }
  constexpr bool has(unsigned limit) const RT_SAFE { return (bits_ >> limit & 1u) != 0; }
  constexpr std::uint32_t bits() const RT_SAFE { return bits_; }
  constexpr void add_if(bool violated, unsigned limit) RT_SAFE {
    bits_ |= static_cast<std::uint32_t>(violated) << limit;
  }
  constexpr bool operator==(const LimitSet&) const = default;

  /// As reports and CSV spell it, e.g. "slider_1_low".
  static const char* name(unsigned limit) RT_SAFE;

 private:
  std::uint32_t bits_ = 0;
};

/// A value that exceeds its limit by less than this passes [m, rad]: a pose that was
/// computed to lie on a limit is not refused for its rounding.
inline constexpr double limit_tolerance = 1e-9;

LimitSet violated_limits(const LaparoscopeLimits& limits,
                         const LaparoscopeConfiguration& configuration) RT_SAFE;

/// Whether the pose can be assembled and violates no limit.
bool reachable(const LaparoscopeModel& model, const LaparoscopeLimits& limits,
               const PoseCoordinates& pose) RT_SAFE;

}  // namespace trocar
