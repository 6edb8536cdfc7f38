// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/loop_definition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "framework/scripting/loop_world.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

constexpr const char* kind_key = "trocar.kind";

/// trocar.fixture { … } and trocar.component { … }: the table, and a note of which it was.
int define(lua_State* state) {
  const char* kind = lua_tostring(state, lua_upvalueindex(1));
  if (lua_gettop(state) != 1 || !lua_istable(state, 1))
    return luaL_error(state, "trocar.%s takes one table: trocar.%s { step = function … end }", kind,
                      kind);
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_setfield(state, LUA_REGISTRYINDEX, kind_key);
  return 1;
}

void open_definitions(lua_State* state) {
  lua_rawgeti(state, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  lua_pushliteral(state, "trocar");
  lua_newtable(state);
  const int definitions = lua_gettop(state);
  for (const char* kind : {"fixture", "component"}) {
    lua_pushstring(state, kind);
    lua_pushcclosure(state, define, 1);
    lua_setfield(state, definitions, kind);
  }
  push_world_function(state, "setmetatable");
  lua_pushvalue(state, definitions);
  lua_newtable(state);
  push_world_function(state, "no_such");
  lua_pushliteral(state, "trocar");
  lua_pushvalue(state, definitions);
  lua_call(state, 2, 1);
  lua_setfield(state, -2, "__index");
  lua_call(state, 2, 0);
  lua_rawset(state, -3);
  lua_pop(state, 1);
}

}  // namespace

bool load_definition(LoopState& loop, LawKind kind, std::string_view text) {
  lua_State* state = loop.lua();
  open_definitions(state);
  if (!loop.run_file(text, 1)) return false;
  lua_getfield(state, LUA_REGISTRYINDEX, kind_key);
  const std::string made = lua_isstring(state, -1) ? lua_tostring(state, -1) : "";
  lua_pop(state, 1);
  const std::string wanted = kind == LawKind::fixture ? "fixture" : "component";
  const std::string other = kind == LawKind::fixture ? "LuaComponent" : "LuaFixture";
  if (made == wanted && lua_istable(state, -1)) return true;
  if (!made.empty() && made != wanted)
    loop.set_error(
        1, fmt::format("returns a trocar.{}: use it by trocar.{} {{ file = … }}", made, other));
  else
    loop.set_error(
        1,
        fmt::format("returns {}: let it end with return trocar.{} {{ step = function "
                    "… end }}",
                    lua_isnil(state, -1) ? "nothing" : "a " + std::string(luaL_typename(state, -1)),
                    wanted));
  return false;
}

void add_loop_error(std::string_view name, const std::string& path, std::string_view error,
                    Findings& findings) {
  int line = 0;
  std::string_view what = error.substr(std::min(error.size(), name.size() + 1));
  const auto end = std::from_chars(what.data(), what.data() + what.size(), line).ptr;
  if (line > 0) what = what.substr(static_cast<std::size_t>(end - what.data()) + 1);
  findings.add({path, line}, std::string(trim(what)));
}

}  // namespace trocar::lua
