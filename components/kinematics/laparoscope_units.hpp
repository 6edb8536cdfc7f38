// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Units of the laparoscope's six axes, as its ports declare them.

namespace trocar {

inline constexpr const char* laparoscope_position_units = "m, m, m, rad, rad, rad";
inline constexpr const char* laparoscope_velocity_units = "m/s, m/s, m/s, rad/s, rad/s, rad/s";
inline constexpr const char* laparoscope_effort_units = "N, N, N, N m, N m, N m";

}  // namespace trocar
