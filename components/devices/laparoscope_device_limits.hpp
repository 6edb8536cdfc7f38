// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_geometry.hpp"
#include "framework/device.hpp"

namespace trocar {

/// What the laparoscope can bear, for its gate. @param period [s] between two reports
DeviceLimits laparoscope_device_limits(const LaparoscopeLimits& ranges, double period);

/// Largest load of one stage of the tool: the sliders' peak effort. [N]
inline constexpr double laparoscope_stage_force = 200.0;

}  // namespace trocar
