// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <lua.hpp>
#include <optional>
#include <string>

#include "framework/finding.hpp"
#include "framework/literal.hpp"

namespace trocar::lua {

/// The table at `index` as a value; nothing where it has more than 2000 entries or is nested more
/// than 8 deep, as one is that holds itself.
std::optional<Literal> definition_at(lua_State* state, int index);

/// Runs a file that returns a definition, in a world of the loop's kind: it sees no files and no
/// graph, and is ended after a million instructions.
/// @param name as errors call it
/// @param path as findings do
/// @return nothing, and a finding with its line, where it fails or returns no table
std::optional<Literal> read_definition(const std::string& name, const std::string& path,
                                       std::string_view text, Findings& findings);

}  // namespace trocar::lua
