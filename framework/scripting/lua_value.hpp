// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <lua.hpp>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "framework/finding.hpp"
#include "framework/literal.hpp"

/// @file
/// C++ values in Lua. The Lua library is the one built as C++, so that an error of Lua's runs the
/// destructors of the frames that it leaves.

namespace trocar::lua {

/// The name of the metatable of the C++ type T.
template <typename T>
struct Meta;  // specialised with: static constexpr const char* name

/// Pushes a copy of `value` as a userdata.
template <typename T>
void push(lua_State* state, T value) {
  new (lua_newuserdatauv(state, sizeof(T), 0)) T(std::move(value));
  luaL_setmetatable(state, Meta<T>::name);
}

/// The userdata at `index` as a T, or null when it is something else.
template <typename T>
T* get(lua_State* state, int index) {
  return static_cast<T*>(luaL_testudata(state, index, Meta<T>::name));
}

/// The userdata that a method was called on.
/// @throw std::invalid_argument when it is something else: a dot instead of a colon
template <typename T>
T& self(lua_State* state, const char* example) {
  if (T* found = get<T>(state, 1)) return *found;
  throw std::invalid_argument(std::string("a method is called with a colon: ") + example);
}

/// A C++ exception in a function that Lua calls becomes a Lua error.
template <lua_CFunction Function>
int guarded(lua_State* state) {
  try {
    return Function(state);
  } catch (const std::exception& error) {
    luaL_where(state, 1);
    lua_pushstring(state, error.what());
  }
  lua_concat(state, 2);
  return lua_error(state);
}

/// Makes the metatable of T with the given functions and a destructor; leaves nothing.
template <typename T>
void make_metatable(lua_State* state, const luaL_Reg* functions) {
  luaL_newmetatable(state, Meta<T>::name);
  lua_pushcfunction(state, [](lua_State* s) {
    static_cast<T*>(lua_touserdata(s, 1))->~T();
    return 0;
  });
  lua_setfield(state, -2, "__gc");
  lua_pushboolean(state, 0);
  lua_setfield(state, -2, "__metatable");
  luaL_setfuncs(state, functions, 0);
  lua_pop(state, 1);
}

/// File and line of the script that is running.
Where where(lua_State* state);

/// The keys of the table at `index`: 1 to n first, then strings in alphabetical order. Lua's own
/// order differs from run to run.
struct Key {
  lua_Integer number = 0;  // 0 where it is a text
  std::string text{};
};
std::vector<Key> ordered_keys(lua_State* state, int index);
bool comes_before(const Key& a, const Key& b);
/// Pushes the value of a key.
void push_value(lua_State* state, int table, const Key& key);

/// What a script wrote: nil, bool, number, string, or a table of such; anything else becomes a
/// string that says what it is.
Literal to_literal(lua_State* state, int index);
void push_literal(lua_State* state, const Literal& literal);

}  // namespace trocar::lua
