// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/loop_world.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "framework/scripting/loop_guard.hpp"
#include "framework/scripting/lua_value.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

constexpr int price_of_a_conversion = 200;  // [instructions] "%.99f" of a huge number
constexpr const char* functions_key = "trocar";

LoopGuard& guard_of(lua_State* state) {
  void* guard = nullptr;
  lua_getallocf(state, &guard);
  return *static_cast<LoopGuard*>(guard);
}

/// refuse(…): an error of these texts and numbers, one after the other.
int refuse(lua_State* state) {
  std::string text;
  for (int i = 1; i <= lua_gettop(state); ++i) {
    text += luaL_tolstring(state, i, nullptr);
    lua_pop(state, 1);
  }
  return luaL_error(state, "%s", text.c_str());
}

/// show(value): as errors print it, without an address.
int show(lua_State* state) {
  switch (lua_type(state, 1)) {
    case LUA_TSTRING:
      lua_pushfstring(state, "\"%s\"", lua_tostring(state, 1));
      return 1;
    case LUA_TNIL:
    case LUA_TNUMBER:
    case LUA_TBOOLEAN:
      luaL_tolstring(state, 1, nullptr);
      return 1;
    default:
      lua_pushfstring(state, "a %s", luaL_typename(state, 1));
      return 1;
  }
}

/// string.format without %p, which would show an address, and paid for by the conversion.
int format(lua_State* state) {
  const std::string_view text = luaL_checkstring(state, 1);
  std::int64_t conversions = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != '%') continue;
    ++conversions;
    const std::size_t letter = text.find_first_not_of("-+#0 .123456789", i + 1);
    if (letter != std::string_view::npos && text[letter] == 'p')
      return luaL_error(state, "string.format: %%p shows an address, which differs in every run");
    if (text[i + 1] == '%') ++i;
  }
  guard_of(state).charge(conversions * price_of_a_conversion);
  for (int i = 2; i <= lua_gettop(state); ++i)
    if (lua_type(state, i) == LUA_TTABLE && luaL_getmetafield(state, i, "__tostring") == LUA_TNIL)
      return luaL_error(state, "string.format: a table has no text");
    else
      lua_settop(state, std::max(i, lua_gettop(state)));
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_call(state, lua_gettop(state) - 1, 1);
  return 1;
}

/// sort_names(list): in place and alphabetically, paid for by their number alone, since the order
/// in which they come differs in every run.
int sort_names(lua_State* state) {
  constexpr lua_Unsigned most = 128;
  const lua_Unsigned count = lua_rawlen(state, 1);
  if (count > most) return luaL_error(state, "pairs: at most %d names", static_cast<int>(most));
  guard_of(state).charge(10 * static_cast<std::int64_t>(count));
  luaL_checkstack(state, static_cast<int>(count) + 2, "pairs");
  std::array<int, most> order{};
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(count);
  for (auto at = order.begin(); at != end; ++at) {
    lua_rawgeti(state, 1, 1 + (at - order.begin()));
    *at = lua_gettop(state);
  }
  std::sort(order.begin(), end, [state](int a, int b) {
    return std::strcmp(lua_tostring(state, a), lua_tostring(state, b)) < 0;
  });
  for (auto at = order.begin(); at != end; ++at) {
    lua_pushvalue(state, *at);
    lua_rawseti(state, 1, 1 + (at - order.begin()));
  }
  return 0;
}

int has_text(lua_State* state) {
  lua_pushboolean(state, luaL_getmetafield(state, 1, "__tostring") != LUA_TNIL);
  return 1;
}

std::vector<std::string> names_in(lua_State* state, int index) {
  std::vector<std::string> names;
  if (!lua_istable(state, index)) return names;
  for (const Key& key : ordered_keys(state, index))
    if (key.number == 0) names.push_back(key.text);
  return names;
}

/// Locals and upvalues of the function that is running.
void add_locals(lua_State* state, std::vector<std::string>& names) {
  lua_Debug frame;
  if (lua_getstack(state, 1, &frame) == 0) return;
  const auto add = [&](const char* name) {
    lua_pop(state, 1);
    if (name[0] != '(' && name[0] != '_') names.emplace_back(name);
  };
  for (int i = 1;; ++i)
    if (const char* name = lua_getlocal(state, &frame, i)) {
      add(name);
    } else {
      break;
    }
  lua_getinfo(state, "f", &frame);
  const int function = lua_gettop(state);
  for (int i = 1;; ++i)
    if (const char* name = lua_getupvalue(state, function, i)) {
      add(name);
    } else {
      break;
    }
}

/// __index of a guarded table. Upvalues: owner, the table of known names, cures or nil.
int no_such_name(lua_State* state) {
  const std::string owner = lua_tostring(state, lua_upvalueindex(1));
  const std::string name = luaL_tolstring(state, 2, nullptr);
  const int cures = lua_upvalueindex(3);
  if (lua_istable(state, cures) && lua_getfield(state, cures, name.c_str()) == LUA_TSTRING)
    throw std::invalid_argument((owner.empty() ? "" : owner + ".") + name +
                                " is not there inside the loop: " + lua_tostring(state, -1));
  std::vector<std::string> known = names_in(state, lua_upvalueindex(2));
  if (owner == "out" && std::find(known.begin(), known.end(), name) != known.end())
    throw std::invalid_argument("out." + name + " is nil: step has to leave a value there");
  if (owner.empty()) add_locals(state, known);
  const std::string near = nearest(name, known);
  const std::string what =
      owner.empty()
          ? "there is no variable \"" + name + "\""
          : owner + " has no " +
                (lua_type(state, 2) == LUA_TSTRING ? "\"" + name + "\"" : "[" + name + "]");
  throw std::invalid_argument(what + (owner.empty() && near.empty()
                                          ? ": declare it, local " + name + " = …"
                                          : suggestion(name, known)));
}

/// __newindex of a guarded table. Upvalues: owner, the cure, the table of known names or nil.
int no_assignment(lua_State* state) {
  const std::string owner = lua_tostring(state, lua_upvalueindex(1));
  const std::string name = luaL_tolstring(state, 2, nullptr);
  const std::string cure = lua_tostring(state, lua_upvalueindex(2));
  const std::vector<std::string> known = names_in(state, lua_upvalueindex(3));
  const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
  const std::string near = is_known ? "" : nearest(name, known);
  const std::string whole = owner.empty() ? name : owner + "." + name;
  throw std::invalid_argument("\"" + whole + "\" cannot be assigned to" +
                              (near.empty() ? ": " + cure : ", did you mean \"" + near + "\"?"));
}

int make_no_such(lua_State* state) {
  lua_settop(state, 3);
  lua_pushcclosure(state, guarded<no_such_name>, 3);
  return 1;
}

int make_no_assign(lua_State* state) {
  lua_settop(state, 3);
  lua_pushcclosure(state, guarded<no_assignment>, 3);
  return 1;
}

void open_library(lua_State* state, const char* name, lua_CFunction open) {
  lua_pushcfunction(state, open);
  lua_pushstring(state, name);
  lua_call(state, 1, 1);
  lua_setfield(state, -2, name);
}

/// Lua's own functions, and ours in C, as a table that only the world's own chunks see.
void push_raw(lua_State* state) {
  lua_pushcfunction(state, luaopen_base);
  lua_call(state, 0, 1);
  open_library(state, "string", luaopen_string);
  open_library(state, "table", luaopen_table);
  open_library(state, "math", luaopen_math);
  const luaL_Reg own[] = {{"refuse", refuse},        {"show", show},
                          {"has_text", has_text},    {"sort_names", sort_names},
                          {"no_such", make_no_such}, {"no_assign", make_no_assign},
                          {nullptr, nullptr}};
  luaL_setfuncs(state, own, 0);
  lua_getfield(state, -1, "string");
  lua_getfield(state, -1, "format");
  lua_pushcclosure(state, format, 1);
  lua_setfield(state, -3, "format");
  lua_pop(state, 1);
  lua_pushinteger(state, static_cast<lua_Integer>(LoopGuard::longest_text));
  lua_setfield(state, -2, "longest_text");
  lua_pushliteral(state, "");
  lua_getmetatable(state, -1);
  lua_setfield(state, -3, "string_metatable");
  lua_pop(state, 1);
}

/// Runs a chunk of the world with the values at the top as its arguments.
void run_chunk(lua_State* state, std::string_view text, int arguments) {
  const std::string name = "=" + std::string(world_chunk);
  if (luaL_loadbufferx(state, text.data(), text.size(), name.c_str(), "t") != LUA_OK)
    lua_error(state);
  lua_insert(state, -1 - arguments);
  lua_call(state, arguments, 1);
}

}  // namespace

int open_loop_world(lua_State* state) {
  const lua_Integer seed = luaL_checkinteger(state, 1);
  push_raw(state);
  const int raw = lua_gettop(state);
  lua_getfield(state, raw, "math");
  lua_getfield(state, -1, "randomseed");
  lua_pushinteger(state, seed);
  lua_call(state, 1, 0);
  lua_settop(state, raw);

  lua_pushvalue(state, raw);
  run_chunk(state, loop_vectors_text(), 1);
  for (const char* name : {"setmetatable", "next", "no_such", "no_assign"}) {
    lua_getfield(state, raw, name);
    lua_setfield(state, -2, name);
  }
  lua_pushvalue(state, -1);
  lua_setfield(state, LUA_REGISTRYINDEX, functions_key);
  const int vectors = lua_gettop(state);
  lua_pushvalue(state, raw);
  lua_pushvalue(state, vectors);
  run_chunk(state, loop_library_text(), 2);
  // What is compiled from now on sees this as its globals, and nothing else knows the old ones.
  lua_rawseti(state, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  lua_pushnil(state);
  lua_setfield(state, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  lua_settop(state, 0);
  return 0;
}

void push_world_function(lua_State* state, const char* name) {
  lua_getfield(state, LUA_REGISTRYINDEX, functions_key);
  lua_getfield(state, -1, name);
  lua_remove(state, -2);
}

}  // namespace trocar::lua
