// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/definition_file.hpp"

#include <fmt/format.h>

#include "framework/scripting/loop_definition.hpp"
#include "framework/scripting/lua_value.hpp"

namespace trocar::lua {
namespace {

constexpr int deepest_definition = 8;
constexpr int most_entries = 2000;

/// Takes the table's entries off `left`.
bool fits(lua_State* state, int index, int depth, int& left) {
  if (depth > deepest_definition) return false;
  luaL_checkstack(state, 4, "a nested table");
  const int table = lua_absindex(state, index);
  lua_pushnil(state);
  while (lua_next(state, table) != 0) {
    const bool one_more =
        --left >= 0 && (!lua_istable(state, -1) || fits(state, -1, depth + 1, left));
    lua_pop(state, one_more ? 1 : 2);
    if (!one_more) return false;
  }
  return true;
}

/// What the guard says is for laws, which have parameters to raise its limits.
std::string breach_of(const LoopState& state) {
  switch (state.guard().breach()) {
    case LoopBreach::none:
      return "";
    case LoopBreach::instructions:
      return fmt::format("took more than {} instructions: it has to return a table, and to end",
                         state.guard().budget());
    default:
      return "makes more tables or text than a definition needs";
  }
}

}  // namespace

std::optional<Literal> definition_at(lua_State* state, int index) {
  int left = most_entries;
  if (!fits(state, index, 1, left)) return std::nullopt;
  return to_literal(state, index);
}

std::optional<Literal> read_definition(const std::string& name, const std::string& path,
                                       std::string_view text, Findings& findings) {
  LoopState state({}, name, 1);
  if (!state.run_file(text, 1)) {
    const std::string breach = breach_of(state);
    const LoopTrace& trace = state.guard().trace();
    if (breach.empty())
      add_loop_error(name, path, state.error(), findings);
    else
      findings.add({path, trace.count > 0 ? trace.frames[0].line : 0}, breach);
    return std::nullopt;
  }
  if (!lua_istable(state.lua(), -1)) {
    findings.add({path, 1}, fmt::format("returns {}: let it end with return {{ … }}",
                                        lua_isnil(state.lua(), -1)
                                            ? "nothing"
                                            : "a " + std::string(luaL_typename(state.lua(), -1))));
    return std::nullopt;
  }
  auto value = definition_at(state.lua(), -1);
  if (!value) findings.add({path, 1}, "returns a table that is too large, or holds itself");
  return value;
}

}  // namespace trocar::lua
