// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/registry.hpp"

namespace trocar {

/// Adds every built-in component type.
void register_components(Registry& registry);

}  // namespace trocar
