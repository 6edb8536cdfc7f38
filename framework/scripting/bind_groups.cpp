// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "framework/scripting/declared_parameters.hpp"
#include "framework/scripting/script_context.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

/// The parameters that a script declares for its group.
class GroupParameters final : public ParameterSet {
 public:
  DeclaredParameters declared;
};

std::unique_ptr<GroupParameters> declare_all(lua_State* state, int definition) {
  auto parameters = std::make_unique<GroupParameters>();
  lua_getfield(state, definition, "parameters");
  if (lua_istable(state, -1)) {
    const int table = lua_gettop(state);
    for (const Key& key : ordered_keys(state, table)) {
      push_value(state, table, key);
      if (lua_istable(state, -1) && is_name(key.text))
        parameters->declared.declare(*parameters, read_declared_parameter(state, key.text));
      else
        context(state).graph().finding(
            where(state), fmt::format("group parameter \"{}\": needs {{ default, range = {{…}} }}",
                                      key.number > 0 ? std::to_string(key.number) : key.text));
      lua_pop(state, 1);
    }
  }
  lua_pop(state, 1);
  return parameters;
}

/// The names in a list { "force" }, or the keys of a table { force = "N" }.
std::vector<std::string> declared_names(lua_State* state, int definition, const char* field) {
  std::vector<std::string> names;
  lua_getfield(state, definition, field);
  if (lua_istable(state, -1)) {
    const int declared = lua_gettop(state);
    for (const Key& key : ordered_keys(state, declared)) {
      push_value(state, declared, key);
      if (key.number == 0)
        names.push_back(key.text);
      else if (lua_type(state, -1) == LUA_TSTRING)
        names.emplace_back(lua_tostring(state, -1));
      lua_pop(state, 1);
    }
  }
  lua_pop(state, 1);
  return names;
}

int no_entry(lua_State* state) {
  const std::string kind = lua_tostring(state, lua_upvalueindex(1));
  const std::string name = luaL_tolstring(state, 2, nullptr);
  std::vector<std::string> known;
  for (const Key& key : ordered_keys(state, 1)) known.push_back(key.text);
  return push_placeholder(
      state, name,
      fmt::format("the group has no {} \"{}\"{}", kind, name, suggestion(name, known)));
}

/// Pushes a table in which a name that is missing is a finding.
void push_named_table(lua_State* state, const char* kind) {
  lua_newtable(state);
  lua_newtable(state);
  lua_pushstring(state, kind);
  lua_pushcclosure(state, guarded<no_entry>, 1);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
}

/// Pushes the table that `build` gets as its first argument: references to the parameters.
void push_parameters(lua_State* state, NodeId group) {
  push_named_table(state, "parameter");
  for (const std::string& name : context(state).graph().node(group).settings().parameter_names()) {
    push(state, ParameterRef{group, name});
    lua_setfield(state, -2, name.c_str());
  }
}

/// Pushes the table of inputs: what the instance was given for each declared name.
void push_inputs(lua_State* state, int definition, int arguments, const std::string& name) {
  push_named_table(state, "input");
  for (const std::string& input : declared_names(state, definition, "inputs")) {
    lua_getfield(state, arguments, input.c_str());
    if (lua_isnil(state, -1)) {
      lua_pop(state, 1);
      push_placeholder(state, name + "." + input,
                       fmt::format("{} needs its input \"{}\"", name, input));
    }
    lua_setfield(state, -2, input.c_str());
  }
}

/// What `build` returned, at the top of the stack, becomes the group's members.
void export_members(lua_State* state, NodeId group) {
  Graph& graph = context(state).graph();
  const int table = lua_gettop(state);
  if (!lua_istable(state, table)) return;
  refuse_odd_keys(state, table, graph.node(group).name + ": what build returned");
  for (const Key& key : ordered_keys(state, table)) {
    if (key.number > 0) continue;
    push_value(state, table, key);
    Exports& exports = graph.node(group).exports;
    if (const auto* output = get<OutputRef>(state, -1))
      exports.outputs[key.text] = *output;
    else if (const auto* input = get<InputRef>(state, -1))
      exports.inputs[key.text] = *input;
    else if (const auto* site = get<SiteRef>(state, -1))
      exports.sites[key.text] = site->site;
    else if (const auto* node = get<NodeRef>(state, -1))
      exports.parts[key.text] = node->node;
    else if (get<Placeholder>(state, -1) == nullptr)
      graph.finding(where(state),
                    fmt::format("{}: build returned \"{}\", which is no output, input, "
                                "site or component",
                                graph.node(group).name, key.text));
    lua_pop(state, 1);
  }
}

void check_entries(lua_State* state, NodeId group, int definition, int arguments) {
  Graph& graph = context(state).graph();
  const Graph::Node& node = graph.node(group);
  std::vector<std::string> known = node.settings().parameter_names();
  known.emplace_back("name");
  known.emplace_back("thread");
  for (std::string& input : declared_names(state, definition, "inputs"))
    known.push_back(std::move(input));
  refuse_odd_keys(state, arguments, node.name);
  for (const Key& key : ordered_keys(state, arguments)) {
    if (key.number > 0) continue;
    if (std::find(known.begin(), known.end(), key.text) == known.end())
      graph.finding(where(state), fmt::format("{} has no input or parameter \"{}\"{}", node.name,
                                              key.text, suggestion(key.text, known)));
    else if (node.settings().find_parameter(key.text) != nullptr) {
      push_value(state, arguments, key);
      apply_entry(state, group, key.text);
      lua_pop(state, 1);
    }
  }
}

/// Every output that the definition declares has to be in what `build` returned, at the top.
void require_outputs(lua_State* state, NodeId group, int definition) {
  Graph& graph = context(state).graph();
  const int result = lua_gettop(state);
  for (const std::string& name : declared_names(state, definition, "outputs")) {
    const bool given =
        lua_istable(state, result) && lua_getfield(state, result, name.c_str()) != LUA_TNIL;
    lua_settop(state, result);
    if (!given)
      graph.finding(where(state), fmt::format("{}: build did not return the output \"{}\"",
                                              graph.node(group).name, name));
  }
}

/// The constructor that trocar.group returned; its definition is an upvalue.
int construct_group(lua_State* state) {
  ScriptContext& script = context(state);
  if (lua_isnoneornil(state, 1)) lua_newtable(state);
  if (!lua_istable(state, 1))
    return push_placeholder(state, "group", "a group takes one table, e.g. { name = \"a_name\" }");
  lua_settop(state, 1);
  lua_pushvalue(state, lua_upvalueindex(1));
  const int definition = 2;
  lua_getfield(state, definition, "name");
  const std::string type = lua_isstring(state, -1) ? lua_tostring(state, -1) : "Group";
  lua_pop(state, 1);
  const std::string name = given_name(state, 1, "");
  const ThreadScope scope(script.graph(), thread_given(state, 1));
  const auto group = script.graph().add_group(declare_all(state, definition), type, name,
                                              where(state), script.scope());
  if (!group) {
    push(state, Placeholder{type});
    return 1;
  }
  check_entries(state, *group, definition, 1);
  const std::string full = script.graph().node(*group).name;
  lua_getfield(state, definition, "build");
  push_parameters(state, *group);
  push_inputs(state, definition, 1, full);
  script.scopes.push_back(full);
  const std::size_t first_part = script.graph().size();
  const int status = lua_pcall(state, 2, 1, 0);
  script.scopes.pop_back();
  if (status != LUA_OK) return lua_error(state);
  for (NodeId id = first_part; id < script.graph().size(); ++id) {
    const std::string part = script.graph().node(id).name.substr(full.size() + 1);
    if (part.find('.') == std::string::npos) script.graph().node(*group).exports.parts[part] = id;
  }
  export_members(state, *group);
  require_outputs(state, *group, definition);
  push(state, NodeRef{*group});
  return 1;
}

int make_group(lua_State* state) {
  if (!lua_istable(state, 1))
    return push_placeholder(state, "group", "trocar.group takes one table, with build = function");
  lua_settop(state, 1);
  static const std::vector<std::string> known = {"name", "parameters", "inputs", "outputs",
                                                 "build"};
  for (const Key& key : ordered_keys(state, 1))
    if (std::find(known.begin(), known.end(), key.text) == known.end())
      context(state).graph().finding(
          where(state),
          fmt::format("trocar.group has no \"{}\"{}", key.text, suggestion(key.text, known)));
  lua_getfield(state, 1, "build");
  if (!lua_isfunction(state, -1))
    return push_placeholder(state, "group",
                            "trocar.group needs build = function(parameters, inputs) … end");
  lua_pop(state, 1);
  lua_pushcclosure(state, guarded<construct_group>, 1);
  return 1;
}

}  // namespace

void open_groups(lua_State* state) {
  lua_pushcfunction(state, guarded<make_group>);
  lua_setfield(state, -2, "group");
}

}  // namespace trocar::lua
