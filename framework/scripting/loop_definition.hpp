// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "framework/scripting/law_file.hpp"
#include "framework/scripting/loop_state.hpp"

namespace trocar::lua {

/// Runs a law's file, and leaves the table that it gave to trocar.fixture or trocar.component on
/// the stack.
/// @return false where it failed or is of another kind: the state's error() says why
bool load_definition(LoopState& state, LawKind kind, std::string_view text);

}  // namespace trocar::lua
