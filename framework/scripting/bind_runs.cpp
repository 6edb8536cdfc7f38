// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "framework/scripting/run_columns.hpp"
#include "framework/scripting/run_options.hpp"
#include "framework/scripting/script_context.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

/// What ends a script early and in order; no user sees it.
constexpr const char* stop_here = "trocar: the script stops here";

// --- trocar.run -------------------------------------------------------------------------------

int run_graph(lua_State* state) {
  if (!lua_istable(state, 1))
    throw std::invalid_argument("trocar.run takes one table, e.g. { duration = \"10 s\" }");
  return run_session(state, context(state).session,
                     run_options_at(state, 1, default_run_options()));
}

/// What has no value of its own, a function say, would be published as its address.
void refuse_opaque(lua_State* state, int index, const std::string& name, int depth) {
  const int at = lua_absindex(state, index);
  if (lua_istable(state, at) && depth < 16) {
    for (const Key& key : ordered_keys(state, at)) {
      push_value(state, at, key);
      const std::string part = key.number > 0 ? std::to_string(key.number) : key.text;
      refuse_opaque(state, -1, name.empty() ? part : name + "." + part, depth + 1);
      lua_pop(state, 1);
    }
    return;
  }
  const int type = lua_type(state, at);
  if (type == LUA_TFUNCTION || type == LUA_TUSERDATA || type == LUA_TTHREAD)
    throw std::invalid_argument(fmt::format(
        "publish: \"{}\" is a {}; publish numbers, texts, true, false and tables of them", name,
        lua_typename(state, type)));
}

int publish(lua_State* state) {
  if (lua_type(state, 1) != LUA_TSTRING || !lua_istable(state, 2))
    throw std::invalid_argument(
        "trocar.publish takes a name and a table, e.g. (\"drift\", { tip = 0.1 })");
  const std::string name = lua_tostring(state, 1);
  if (!is_name(name))
    throw std::invalid_argument(
        fmt::format("publish(\"{}\"): needs a name of letters, digits and "
                    "underscores",
                    name));
  refuse_opaque(state, 2, "", 0);
  context(state).session.publish(name, to_literal(state, 2));
  return 0;
}

/// The file that a reload names.
void read_law_text(lua_State* state, Reload& reload) {
  const std::string path = (context(state).folder / reload.file).string();
  auto text = read_file(path);
  if (!text)
    throw std::invalid_argument(
        fmt::format("reloads.{} = \"{}\": there is no file {} that can be read", reload.component,
                    reload.file, path));
  reload.path = path;
  reload.text = std::move(*text);
}

}  // namespace

RunOptions run_options_at(lua_State* state, int index, RunOptions base) {
  const int table = lua_absindex(state, index);
  RunOptions options = read_run_options(to_literal(state, table), where(state), std::move(base));
  for (Reload& reload : options.reloads) read_law_text(state, reload);
  if (lua_getfield(state, table, "keep") == LUA_TTABLE) {
    options.keep.clear();
    for (lua_Integer i = 1; lua_rawgeti(state, -1, i) != LUA_TNIL; ++i) {
      options.keep.push_back(signal_at(state, -1));
      lua_pop(state, 1);
    }
    lua_pop(state, 1);
  }
  lua_pop(state, 1);
  return options;
}

int run_session(lua_State* state, Session& session, RunOptions options) {
  ScriptContext& script = context(state);
  const bool own = &session == &script.session;
  if (script.session.options().check_only) {
    if (own) session.plan(std::move(options));
    script.ran = true;
    return luaL_error(state, "%s", stop_here);
  }
  if (own && !script.ran) script.graph().report_unused_overrides();
  script.ran = true;
  try {
    push(state, RunRef{&session.run(std::move(options))});
    const StopFlag* stop = script.session.options().stop;
    script.stopped = stop != nullptr && stop->raised();
    if (script.stopped) return luaL_error(state, "%s", stop_here);
  } catch (const BrokenGraph& broken) {
    script.broken = broken.findings;
    throw;
  }
  return 1;
}

void open_runs(lua_State* state) {
  lua_pushcfunction(state, guarded<run_graph>);
  lua_setfield(state, -2, "run");
  lua_pushcfunction(state, guarded<publish>);
  lua_setfield(state, -2, "publish");
  open_results(state);
}

}  // namespace trocar::lua
