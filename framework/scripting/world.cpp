// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/world.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "framework/text.hpp"

namespace trocar::lua {
namespace {

const char context_key = 0;

/// Names that a line of a script can see.
std::vector<std::string> visible_names(lua_State* state) {
  std::vector<std::string> names;
  lua_Debug frame;
  for (int level = 0; lua_getstack(state, level, &frame) != 0; ++level)
    for (int i = 1;; ++i) {
      const char* name = lua_getlocal(state, &frame, i);
      if (name == nullptr) break;
      lua_pop(state, 1);
      if (name[0] != '(') names.emplace_back(name);
    }
  lua_pushglobaltable(state);
  for (const Key& key : ordered_keys(state, -1)) names.push_back(key.text);
  lua_pop(state, 1);
  return names;
}

int unknown_global(lua_State* state) {
  const std::string name = luaL_checkstring(state, 2);
  for (const char* word : {"describe", "it", "before_each", "expect"})
    if (name == word)
      return luaL_error(state, "%s is for specs: run them by `trocar test FILE_spec.lua`", word);
  const std::vector<std::string> known = visible_names(state);
  return push_placeholder(state, name,
                          fmt::format("there is no variable \"{}\"{}", name,
                                      nearest(name, known).empty() ? "" : suggestion(name, known)));
}

int argument(lua_State* state) {
  ScriptContext& script = context(state);
  script.asked.emplace_back(luaL_checkstring(state, 2));
  const auto found = script.arguments.find(script.asked.back());
  if (found == script.arguments.end()) return 0;
  found->second.used = true;
  push_literal(state, found->second.value);
  return 1;
}

void open_arguments(lua_State* state) {
  lua_newtable(state);
  lua_newtable(state);
  lua_pushcfunction(state, guarded<argument>);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
  lua_setfield(state, -2, "args");
}

/// `debug` would reach behind the binding, os.exit() would leave half a log.
void remove_dangers(lua_State* state) {
  lua_pushnil(state);
  lua_setglobal(state, "debug");
  lua_getfield(state, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
  lua_pushnil(state);
  lua_setfield(state, -2, "debug");
  lua_getglobal(state, "os");
  lua_pushcfunction(state, [](lua_State* s) {
    return luaL_error(s, "os.exit would leave half a log: return, or call error(\"why\")");
  });
  lua_setfield(state, -2, "exit");
  lua_pop(state, 2);
}

/// print() as Lua's, but beside the report where that goes to standard output as JSON.
int print_text(lua_State* state) {
  std::FILE* stream = context(state).session.options().print_to_stderr ? stderr : stdout;
  const int count = lua_gettop(state);
  for (int i = 1; i <= count; ++i) {
    std::size_t size = 0;
    const char* text = luaL_tolstring(state, i, &size);
    if (i > 1) std::fputc('\t', stream);
    std::fwrite(text, 1, size, stream);
    lua_pop(state, 1);
  }
  std::fputc('\n', stream);
  return 0;
}

void seed_random(lua_State* state, std::uint64_t seed) {
  lua_getglobal(state, "math");
  lua_getfield(state, -1, "randomseed");
  lua_pushinteger(state, static_cast<lua_Integer>(seed));
  lua_call(state, 1, 0);
  lua_pop(state, 1);
}

/// All of the script's world: called in protected mode.
int open_world(lua_State* state) {
  luaL_openlibs(state);
  remove_dangers(state);
  lua_pushcfunction(state, print_text);
  lua_setglobal(state, "print");
  open_ordered_pairs(state);
  seed_random(state, context(state).session.options().seed.value_or(1));
  lua_newtable(state);
  open_graph(state);
  open_arithmetic(state);
  open_threads(state);
  open_groups(state);
  open_laws(state);
  open_runs(state);
  open_least_squares(state);
  open_rigs(state);
  open_arguments(state);
  open_require(state);
  lua_setglobal(state, "trocar");
  if (context(state).spec != nullptr) open_specs(state);
  lua_pushglobaltable(state);
  lua_newtable(state);
  lua_pushcfunction(state, guarded<unknown_global>);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
  return 0;
}

/// A script that loops for ever must not outlast the wish to stop it.
void watch_stop_flag(lua_State* state) {
  constexpr int instructions_between_looks = 100'000;
  lua_sethook(
      state,
      [](lua_State* s, lua_Debug* at) {
        const StopFlag* stop = context(s).session.options().stop;
        if (stop == nullptr || !stop->raised()) return;
        lua_getinfo(s, "Sl", at);
        lua_pushfstring(s, "%s:%d: stopped by the operator", at->short_src, at->currentline);
        lua_error(s);
      },
      LUA_MASKCOUNT, instructions_between_looks);
}

/// What a script raised, as a text: error { code = 3 } is one too.
int error_text(lua_State* state) {
  if (lua_type(state, 1) == LUA_TSTRING) return 1;
  const Where at = where(state);
  const std::string what = luaL_getmetafield(state, 1, "__tostring") != LUA_TNIL
                               ? luaL_tolstring(state, 1, nullptr)
                               : fmt::format("error {}", to_literal(state, 1).text());
  lua_pushstring(state, Finding{at, what}.text().c_str());
  return 1;
}

}  // namespace

ScriptContext& context(lua_State* state) {
  lua_rawgetp(state, LUA_REGISTRYINDEX, &context_key);
  auto* found = static_cast<ScriptContext*>(lua_touserdata(state, -1));
  lua_pop(state, 1);
  return *found;
}

World::World(ScriptContext& script) : state_(luaL_newstate(), &lua_close) {
  if (!state_) throw std::bad_alloc();
  lua_pushlightuserdata(state_.get(), &script);
  lua_rawsetp(state_.get(), LUA_REGISTRYINDEX, &context_key);
  lua_pushcfunction(state_.get(), open_world);
  if (lua_pcall(state_.get(), 0, 0, 0) != LUA_OK)
    throw std::runtime_error(fmt::format("Lua does not start: {}", lua_tostring(state_.get(), -1)));
  watch_stop_flag(state_.get());
}

std::optional<std::string> World::run_text(const std::string& path, const std::string& text) {
  const std::string chunk = "@" + path;
  if (luaL_loadbufferx(state_.get(), text.data(), text.size(), chunk.c_str(), "t") != LUA_OK)
    return take_error();
  return call();
}

std::optional<std::string> World::call() {
  lua_pushcfunction(state_.get(), error_text);
  lua_insert(state_.get(), -2);
  const int status = lua_pcall(state_.get(), 0, 0, -2);
  std::optional<std::string> error;
  if (status != LUA_OK) error = take_error();
  lua_pop(state_.get(), 1);
  return error;
}

std::string World::take_error() {
  const char* message = lua_tostring(state_.get(), -1);
  std::string text = message != nullptr ? message : "the script raised an error without text";
  lua_pop(state_.get(), 1);
  return text;
}

}  // namespace trocar::lua
