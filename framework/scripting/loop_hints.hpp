// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "framework/realtime/rt_safe.hpp"

namespace trocar::lua {

/// The cure for what Lua itself complains of, "; …", or "" where none is known.
std::string_view hint_for(std::string_view message) RT_SAFE;

}  // namespace trocar::lua
