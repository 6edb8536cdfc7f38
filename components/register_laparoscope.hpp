// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/registry.hpp"

namespace trocar {

/// The laparoscope's device, kinematics, statics, gravity compensation and the group of them.
void register_laparoscope(Registry& registry);

}  // namespace trocar
