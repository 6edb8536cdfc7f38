// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/script_context.hpp"

namespace trocar::lua {
namespace {

/// pairs() in an order that does not depend on addresses: 1 to n, then names alphabetically.
int ordered_next(lua_State* state) {
  const lua_Integer i = lua_tointeger(state, lua_upvalueindex(3)) + 1;
  lua_pushinteger(state, i);
  lua_replace(state, lua_upvalueindex(3));
  if (lua_rawgeti(state, lua_upvalueindex(2), i) == LUA_TNIL) return 1;
  lua_pushvalue(state, -1);
  lua_gettable(state, lua_upvalueindex(1));
  return 2;
}

bool is_ordered(lua_State* state, int index) {
  return (lua_isinteger(state, index) && lua_tointeger(state, index) > 0) ||
         lua_type(state, index) == LUA_TSTRING;
}

int ordered_pairs(lua_State* state) {
  luaL_checkany(state, 1);
  if (luaL_getmetafield(state, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(state, 1);
    lua_call(state, 1, 3);
    return 3;
  }
  luaL_checktype(state, 1, LUA_TTABLE);
  lua_pushvalue(state, 1);
  lua_newtable(state);
  lua_Integer n = 0;
  for (const Key& key : ordered_keys(state, 1)) {
    if (key.number > 0)
      lua_pushinteger(state, key.number);
    else
      lua_pushstring(state, key.text.c_str());
    lua_rawseti(state, -2, ++n);
  }
  // Keys that are neither, in Lua's order: there is no better one.
  lua_pushnil(state);
  while (lua_next(state, 1) != 0) {
    lua_pop(state, 1);
    if (is_ordered(state, -1)) continue;
    lua_pushvalue(state, -1);
    lua_rawseti(state, -3, ++n);
  }
  lua_pushinteger(state, 0);
  lua_pushcclosure(state, ordered_next, 3);
  return 1;
}

/// Pushes the first key, with its value, that has no order of its own and comes after the key at
/// the top; that key is taken off.
int next_unordered(lua_State* state) {
  while (lua_next(state, 1) != 0) {
    if (!is_ordered(state, -2)) return 2;
    lua_pop(state, 1);
  }
  lua_pushnil(state);
  return 1;
}

/// next() in the same order as pairs().
int ordered_step(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  lua_settop(state, 2);
  if (!lua_isnil(state, 2) && !is_ordered(state, 2)) return next_unordered(state);
  const std::vector<Key> keys = ordered_keys(state, 1);
  std::size_t at = 0;
  if (!lua_isnil(state, 2)) {
    // The key itself may be gone: a loop may clear what it visits.
    Key last;
    if (lua_isinteger(state, 2))
      last.number = lua_tointeger(state, 2);
    else
      last.text = lua_tostring(state, 2);
    while (at < keys.size() && !comes_before(last, keys[at])) ++at;
  }
  if (at == keys.size()) {
    lua_pushnil(state);
    return next_unordered(state);
  }
  if (keys[at].number > 0)
    lua_pushinteger(state, keys[at].number);
  else
    lua_pushstring(state, keys[at].text.c_str());
  push_value(state, 1, keys[at]);
  return 2;
}

}  // namespace

void open_ordered_pairs(lua_State* state) {
  lua_pushcfunction(state, guarded<ordered_pairs>);
  lua_setglobal(state, "pairs");
  lua_pushcfunction(state, guarded<ordered_step>);
  lua_setglobal(state, "next");
}

}  // namespace trocar::lua
