// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/script.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <filesystem>

#include "framework/scripting/script_context.hpp"
#include "framework/text.hpp"

namespace trocar {
namespace lua {
namespace {

const char context_key = 0;

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
  lua_pushcfunction(state, guarded<ordered_pairs>);
  lua_setglobal(state, "pairs");
  lua_pushcfunction(state, guarded<ordered_step>);
  lua_setglobal(state, "next");
  seed_random(state, context(state).session.options().seed.value_or(1));
  lua_newtable(state);
  open_graph(state);
  open_arithmetic(state);
  open_threads(state);
  open_groups(state);
  open_runs(state);
  open_least_squares(state);
  open_arguments(state);
  open_require(state);
  lua_setglobal(state, "trocar");
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

/// "file:3: message" becomes a finding at that line.
void add_error(Graph& graph, const std::string& script, const std::string& message) {
  const std::size_t first = message.starts_with(script + ":") ? script.size() : message.find(':');
  const std::size_t second = first == std::string::npos ? first : message.find(':', first + 1);
  int line = 0;
  if (second != std::string::npos)
    std::from_chars(message.data() + first + 1, message.data() + second, line);
  std::string file = message.substr(0, first);
  if (file.starts_with("...") && script.ends_with(file.substr(3))) file = script;  // Lua's short
  if (line > 0)
    graph.finding({file, line}, std::string(trim(message.substr(second + 1))));
  else
    graph.finding({}, message);
}

}  // namespace

std::string ScriptContext::unused_name(const std::string& stem) {
  return unused_name(stem, scope());
}

std::string ScriptContext::unused_name(const std::string& stem, const std::string& inside) {
  return graph().unused_name(stem, inside);
}

ScriptContext& context(lua_State* state) {
  lua_rawgetp(state, LUA_REGISTRYINDEX, &context_key);
  auto* found = static_cast<ScriptContext*>(lua_touserdata(state, -1));
  lua_pop(state, 1);
  return *found;
}

namespace {

/// Whether the script was ended before its last line, having described or run enough.
bool stopped_on_purpose(const ScriptContext& script) {
  return script.stopped || (script.session.options().check_only && script.ran);
}

void report_unused_arguments(ScriptContext& script) {
  if (stopped_on_purpose(script)) return;  // it might have asked later
  for (const auto& [key, argument] : script.arguments)
    if (!argument.used)
      script.graph().finding(argument.where,
                             fmt::format("the script never asks for trocar.args.{}{}", key,
                                         suggestion(key, script.asked)));
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

void execute(lua_State* state, ScriptContext& script, const std::string& path,
             const std::string& code) {
  const std::string chunk = "@" + path;
  int status = luaL_loadbufferx(state, code.data(), code.size(), chunk.c_str(), "t");
  if (status == LUA_OK) {
    lua_pushcfunction(state, error_text);
    lua_insert(state, 1);
    status = lua_pcall(state, 0, 0, 1);
  }
  if (status == LUA_OK || stopped_on_purpose(script)) return;
  const char* message = lua_tostring(state, -1);
  const std::string text = message != nullptr ? message : "the script raised an error without text";
  if (script.broken && text.find(script.broken->text()) != std::string::npos)
    throw BrokenGraph(*script.broken);
  add_error(script.graph(), path, text);
}

}  // namespace
}  // namespace lua

void run_script(Session& session, const std::string& path, Graph::Overrides arguments) {
  const auto text = lua::read_file(path);
  if (!text) {
    Findings unreadable;
    unreadable.add({path, 0}, "there is no script that can be read");
    throw BrokenGraph(unreadable);
  }
  session.add_script(std::filesystem::path(path).filename().string(), *text);

  lua::ScriptContext script{session, std::move(arguments),
                            std::filesystem::path(path).parent_path()};
  const std::unique_ptr<lua_State, void (*)(lua_State*)> state(luaL_newstate(), &lua_close);
  lua_pushlightuserdata(state.get(), &script);
  lua_rawsetp(state.get(), LUA_REGISTRYINDEX, &lua::context_key);
  lua_pushcfunction(state.get(), lua::open_world);
  if (lua_pcall(state.get(), 0, 0, 0) != LUA_OK)
    throw std::runtime_error(fmt::format("Lua does not start: {}", lua_tostring(state.get(), -1)));
  lua::watch_stop_flag(state.get());
  lua::execute(state.get(), script, path, *text);

  lua::report_unused_arguments(script);
  if (!script.ran || session.options().check_only) session.graph().report_unused_overrides();
  if (session.options().check_only || !session.graph().findings().empty()) {
    if (const Findings findings = check(session.graph(), session.first_wiring()); !findings.empty())
      throw BrokenGraph(findings);
    return;
  }
  if (!script.ran) session.run({});
}

}  // namespace trocar
