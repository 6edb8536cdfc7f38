// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/lua_value.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trocar::lua {
namespace {

constexpr int deepest_table = 16;

Literal nested_literal(lua_State* state, int index, int depth);

Literal table_to_literal(lua_State* state, int index, int depth) {
  if (depth > deepest_table) return {std::string("a table that is nested too deeply")};
  luaL_checkstack(state, 4, "a nested table");
  const int table = lua_absindex(state, index);
  Literal::List list;
  Literal::Table named;
  for (const Key& key : ordered_keys(state, table)) {
    push_value(state, table, key);
    Literal part = nested_literal(state, -1, depth + 1);
    lua_pop(state, 1);
    if (key.number > 0)
      list.push_back(std::move(part));
    else
      named.emplace_back(key.text, std::move(part));
  }
  if (named.empty()) return {std::move(list)};
  for (std::size_t i = 0; i < list.size(); ++i)
    named.emplace_back(std::to_string(i + 1), std::move(list[i]));
  return {std::move(named)};
}

Literal nested_literal(lua_State* state, int index, int depth) {
  switch (lua_type(state, index)) {
    case LUA_TNIL:
      return {};
    case LUA_TBOOLEAN:
      return {lua_toboolean(state, index) != 0};
    case LUA_TNUMBER:
      return {lua_tonumber(state, index)};
    case LUA_TSTRING:
      return {std::string(lua_tostring(state, index))};
    case LUA_TTABLE:
      return table_to_literal(state, index, depth);
    default: {
      Literal text{std::string(luaL_tolstring(state, index, nullptr))};
      lua_pop(state, 1);
      return text;
    }
  }
}

struct Pusher {
  lua_State* state;
  void operator()(std::monostate) const { lua_pushnil(state); }
  void operator()(bool b) const { lua_pushboolean(state, b); }
  void operator()(double d) const { lua_pushnumber(state, d); }
  void operator()(const std::string& s) const { lua_pushlstring(state, s.data(), s.size()); }
  void operator()(const Literal::List& list) const {
    lua_newtable(state);
    for (std::size_t i = 0; i < list.size(); ++i) {
      push_literal(state, list[i]);
      lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
    }
  }
  void operator()(const Literal::Table& table) const {
    lua_newtable(state);
    for (const auto& [key, part] : table) {
      push_literal(state, part);
      lua_setfield(state, -2, key.c_str());
    }
  }
};

}  // namespace

Where where(lua_State* state) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(state, level, &frame) != 0; ++level) {
    lua_getinfo(state, "Sl", &frame);
    if (frame.currentline <= 0) continue;
    return {frame.source[0] == '@' ? frame.source + 1 : frame.short_src, frame.currentline};
  }
  return {};
}

bool comes_before(const Key& a, const Key& b) {
  if ((a.number > 0) != (b.number > 0)) return a.number > 0;
  return a.number != b.number ? a.number < b.number : a.text < b.text;
}

std::vector<Key> ordered_keys(lua_State* state, int index) {
  const int table = lua_absindex(state, index);
  std::vector<Key> keys;
  lua_pushnil(state);
  while (lua_next(state, table) != 0) {
    lua_pop(state, 1);
    if (lua_isinteger(state, -1) && lua_tointeger(state, -1) > 0)
      keys.push_back({lua_tointeger(state, -1), {}});
    else if (lua_type(state, -1) == LUA_TSTRING)
      keys.push_back({0, lua_tostring(state, -1)});
  }
  std::sort(keys.begin(), keys.end(), comes_before);
  return keys;
}

void push_value(lua_State* state, int table, const Key& key) {
  if (key.number > 0)
    lua_rawgeti(state, table, key.number);
  else
    lua_getfield(state, table, key.text.c_str());
}

Literal to_literal(lua_State* state, int index) {
  return nested_literal(state, index, 0);
}

void push_literal(lua_State* state, const Literal& literal) {
  luaL_checkstack(state, 4, "a nested value");
  std::visit(Pusher{state}, literal.value);
}

}  // namespace trocar::lua
