// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "framework/scripting/run_options.hpp"
#include "framework/scripting/script.hpp"
#include "framework/scripting/script_context.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

/// What a script is loaded with: keys with a dot are parameters, the others entries of trocar.args.
struct Settings {
  Graph::Overrides parameters;
  Graph::Overrides arguments;
};

Settings settings_at(lua_State* state, int index, const std::string& function) {
  Settings settings;
  if (lua_isnoneornil(state, index)) return settings;
  if (!lua_istable(state, index))
    throw std::invalid_argument(fmt::format(
        "{} takes a file and a table, e.g. (\"demo.lua\", {{ [\"wall.stiffness\"] = \"1 N/mm\" }})",
        function));
  const Where at = where(state);
  for (const Key& key : ordered_keys(state, index)) {
    if (key.number > 0)
      throw std::invalid_argument(
          fmt::format("{}: entry {} has no name, e.g. [\"wall.stiffness\"] = \"1 N/mm\"", function,
                      key.number));
    push_value(state, index, key);
    Graph::Overrides& target =
        key.text.find('.') == std::string::npos ? settings.arguments : settings.parameters;
    target.insert_or_assign(key.text, Graph::Override{to_literal(state, -1), at});
    lua_pop(state, 1);
  }
  return settings;
}

/// A script of another file, in a session of its own that lives as long as this script's world.
Session& other_session(lua_State* state, const std::string& function, bool describe_only) {
  ScriptContext& script = context(state);
  if (lua_type(state, 1) != LUA_TSTRING)
    throw std::invalid_argument(function + " needs a script's file, e.g. \"demo.lua\"");
  const std::string path = (script.folder / lua_tostring(state, 1)).lexically_normal().string();
  Settings settings = settings_at(state, 2, function);
  SessionOptions options = script.session.options();
  options.set = std::move(settings.parameters);
  options.record.reset();
  options.black_box.reset();
  options.duration.reset();
  options.write_files = false;
  options.check_only = describe_only;
  auto session = std::make_unique<Session>(script.graph().registry(), std::move(options));
  run_script(*session, path, std::move(settings.arguments));
  session->finish();
  script.rigs.push_back(std::move(session));
  return *script.rigs.back();
}

/// trocar.load("demo.lua", { ["wall.stiffness"] = "1 N/mm", subject = 7 })
int load(lua_State* state) {
  push(state, RigRef{&other_session(state, "trocar.load", true)});
  return 1;
}

/// rig:run { duration = "2 s" }
int run_rig(lua_State* state) {
  Session& session = *self<RigRef>(state, "rig:run { duration = \"2 s\" }").session;
  if (lua_isnoneornil(state, 2)) {
    lua_settop(state, 1);
    lua_newtable(state);
  }
  return run_session(state, session,
                     run_options_at(state, 2, session.planned().value_or(default_run_options())));
}

void push_runs(lua_State* state, const Session& session) {
  lua_newtable(state);
  lua_Integer count = 0;
  for (const auto& run : session.runs()) {
    push(state, RunRef{run.get()});
    lua_rawseti(state, -2, ++count);
  }
}

/// Name → list of rows, as in the report.
void push_published(lua_State* state, const Session& session) {
  lua_newtable(state);
  for (const Published& one : session.published()) {
    if (lua_getfield(state, -1, one.name.c_str()) == LUA_TNIL) {
      lua_pop(state, 1);
      lua_newtable(state);
      lua_pushvalue(state, -1);
      lua_setfield(state, -3, one.name.c_str());
    }
    push_literal(state, one.row);
    lua_rawseti(state, -2, luaL_len(state, -2) + 1);
    lua_pop(state, 1);
  }
}

/// trocar.experiment("table1.lua", { devices = 3 }): { runs = {…}, published = { table1 = {…} } }
int experiment(lua_State* state) {
  ScriptContext& script = context(state);
  if (script.session.options().check_only)
    return run_session(state, other_session(state, "trocar.experiment", true), {});
  script.ran = true;
  const Session& session = other_session(state, "trocar.experiment", false);
  if (!session.runs().empty() && session.runs().back()->result.rows == nullptr)
    throw std::invalid_argument(fmt::format(
        "{} is no experiment, for it never calls trocar.run; use trocar.load(…):run {{ … }}",
        lua_tostring(state, 1)));
  lua_newtable(state);
  push_runs(state, session);
  lua_setfield(state, -2, "runs");
  push_published(state, session);
  lua_setfield(state, -2, "published");
  return 1;
}

int rig_index(lua_State* state) {
  const std::string name = luaL_checkstring(state, 2);
  if (name != "run")
    return luaL_error(state, "a loaded script has no \"%s\": rig:run { duration = \"2 s\" } is all",
                      name.c_str());
  lua_pushcfunction(state, guarded<run_rig>);
  return 1;
}

}  // namespace

void open_rigs(lua_State* state) {
  lua_pushcfunction(state, guarded<load>);
  lua_setfield(state, -2, "load");
  lua_pushcfunction(state, guarded<experiment>);
  lua_setfield(state, -2, "experiment");
  const luaL_Reg rig[] = {{"__index", guarded<rig_index>}, {nullptr, nullptr}};
  make_metatable<RigRef>(state, rig);
}

}  // namespace trocar::lua
