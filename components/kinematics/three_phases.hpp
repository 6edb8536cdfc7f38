// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace trocar {

/// Rails, rings and spokes stand at D = (0, 120, 240) deg.
inline constexpr double phase_angle[3] = {0.0, 2.0 * std::numbers::pi / 3.0,
                                          4.0 * std::numbers::pi / 3.0};
inline constexpr double phase_cos[3] = {1.0, -0.5, -0.5};
inline constexpr double phase_sin[3] = {0.0, std::numbers::sqrt3 / 2.0, -std::numbers::sqrt3 / 2.0};

}  // namespace trocar
