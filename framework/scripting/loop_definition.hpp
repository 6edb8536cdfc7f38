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

/// A state's error, "membrane.lua:7: what", becomes a finding at that line of the path.
/// @param name of the file, as the state knows it
void add_loop_error(std::string_view name, const std::string& path, std::string_view error,
                    Findings& findings);

}  // namespace trocar::lua
