// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "framework/component_definition.hpp"

namespace trocar::hid {

/// The files of scripts/layouts, as they were when the library was built.
std::vector<ComponentDefinition::Shipped> shipped_layouts();

}  // namespace trocar::hid
