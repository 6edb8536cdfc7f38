// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cctype>

#include "framework/scripting/script_context.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

// --- looking things up ------------------------------------------------------------------------

std::vector<std::string> member_names(const Graph::Node& node) {
  std::vector<std::string> names = node.settings().parameter_names();
  if (node.component) {
    for (const OutputPort* port : node.component->outputs()) names.push_back(port->name());
    for (const InputPort* port : node.component->inputs()) names.push_back(port->name());
  }
  for (const auto& each : node.exports.outputs) names.push_back(each.first);
  for (const auto& each : node.exports.inputs) names.push_back(each.first);
  for (const auto& each : node.exports.sites) names.push_back(each.first);
  for (const auto& each : node.exports.parts) names.push_back(each.first);
  return names;
}

/// A member of a component or group, pushed; false when there is none of that name.
bool push_member(lua_State* state, const Graph& graph, NodeId id, const std::string& name) {
  const Graph::Node& node = graph.node(id);
  const Exports& exports = node.exports;
  if (const auto site = exports.sites.find(name); site != exports.sites.end())
    push(state, SiteRef{site->second, node.name + "." + name});
  else if (const auto output = exports.outputs.find(name); output != exports.outputs.end())
    push(state, output->second);
  else if (const auto input = exports.inputs.find(name); input != exports.inputs.end())
    push(state, input->second);
  else if (node.component && node.component->find_output(name) != nullptr)
    push(state, OutputRef{id, name, ""});
  else if (node.settings().find_parameter(name) != nullptr)
    push(state, ParameterRef{id, name});
  else if (node.component && node.component->find_input(name) != nullptr)
    push(state, InputRef{id, name});
  else if (const auto part = exports.parts.find(name); part != exports.parts.end())
    push(state, NodeRef{part->second});
  else
    return false;
  return true;
}

const std::string& type_of(const Graph::Node& node) {
  static const std::string group = "group";
  return node.type == nullptr ? group : node.type->name;
}

int node_index(lua_State* state) {
  Graph& graph = context(state).graph();
  const NodeId id = get<NodeRef>(state, 1)->node;
  const std::string name = luaL_checkstring(state, 2);
  if (push_member(state, graph, id, name)) return 1;
  const Graph::Node& node = graph.node(id);
  return push_placeholder(state, node.name + "." + name,
                          fmt::format("{} (a {}) has no \"{}\"{}", node.name, type_of(node), name,
                                      suggestion(name, member_names(node))));
}

// --- constructing -----------------------------------------------------------------------------

void connect_literal(lua_State* state, NodeId node, const std::string& input) {
  Graph& graph = context(state).graph();
  const Where at = where(state);
  const std::string owner = graph.node(node).name;
  const auto constant = graph.add("Constant", input, at, owner);
  if (!constant) return;
  graph.set({*constant, "value"}, to_literal(state, -1), at);
  graph.connect({*constant, "value", ""}, {node, input}, at);
}

void connect_value(lua_State* state, const InputRef& input) {
  Graph& graph = context(state).graph();
  if (const auto* output = get<OutputRef>(state, -1)) {
    graph.connect(*output, input, where(state));
  } else if (lua_istable(state, -1) &&
             graph.node(input.node).component->find_input(input.port)->variadic()) {
    const int list = lua_absindex(state, -1);
    for (const Key& key : ordered_keys(state, list)) {
      push_value(state, list, key);
      connect_value(state, input);
      lua_pop(state, 1);
    }
  } else if (get<Placeholder>(state, -1) != nullptr) {
    graph.node(input.node).excused = true;
  } else if (lua_isuserdata(state, -1)) {
    graph.finding(
        where(state),
        fmt::format("{}.{} is an input: it takes an output or a value, not {}",
                    graph.node(input.node).name, input.port, luaL_tolstring(state, -1, nullptr)));
    lua_pop(state, 1);
  } else {
    connect_literal(state, input.node, input.port);
  }
}

/// Outputs in a value become their signals' names: signals = { wall.force }.
Literal literal_with_signals(lua_State* state, int index) {
  const int at = lua_absindex(state, index);
  if (const auto* output = get<OutputRef>(state, at))
    return {signal_name(context(state).graph(), *output)};
  if (const auto* node = get<NodeRef>(state, at))
    return {context(state).graph().node(node->node).name};
  if (!lua_istable(state, at)) return to_literal(state, at);
  Literal::List list;
  for (const Key& key : ordered_keys(state, at)) {
    if (key.number == 0) return to_literal(state, at);
    push_value(state, at, key);
    list.push_back(literal_with_signals(state, -1));
    lua_pop(state, 1);
  }
  return {list};
}

void set_parameter(lua_State* state, const ParameterRef& parameter) {
  Graph& graph = context(state).graph();
  if (const auto* source = get<ParameterRef>(state, -1))
    graph.link(*source, parameter, where(state));
  else if (get<Placeholder>(state, -1) == nullptr)
    graph.set(parameter, literal_with_signals(state, -1), where(state));
  else
    graph.node(parameter.node).set_at[parameter.name] = where(state);
}

void set_rate(lua_State* state, NodeId node, const std::string& key) {
  Graph& graph = context(state).graph();
  const Graph::Node& known = graph.node(node);
  if (key == "phase") {
    graph.set_rate(node, known.rate, static_cast<std::int64_t>(luaL_checkinteger(state, -1)),
                   where(state));
    return;
  }
  try {
    const Quantity rate = parse_quantity(luaL_checkstring(state, -1));
    if (rate.unit.dimension != parse_unit("Hz").dimension)
      throw UnitError(fmt::format("\"{}\": needs Hz, e.g. \"100 Hz\"", lua_tostring(state, -1)));
    graph.set_rate(node, rate.value, known.phase, where(state));
  } catch (const UnitError& error) {
    graph.finding(where(state), fmt::format("{}.rate = {}", known.name, error.what()));
  }
}

void place_at(lua_State* state, NodeId node) {
  Graph& graph = context(state).graph();
  if (const auto* site = get<SiteRef>(state, -1)) {
    graph.place(node, site->site, where(state));
  } else if (get<Placeholder>(state, -1) != nullptr) {
    graph.node(node).excused = true;
  } else {
    graph.finding(where(state),
                  fmt::format("{}: at = {} is no site, e.g. at = laparoscope.tip",
                              graph.node(node).name, luaL_tolstring(state, -1, nullptr)));
    lua_pop(state, 1);
  }
}

/// The name that the table at the top gives, or "".
std::string given_name(lua_State* state) {
  lua_getfield(state, -1, "name");
  const std::string name = lua_type(state, -1) == LUA_TSTRING ? lua_tostring(state, -1) : "";
  lua_pop(state, 1);
  return name;
}

int construct_closure(lua_State* state) {
  const std::string type = lua_tostring(state, lua_upvalueindex(1));
  if (!lua_istable(state, 1))
    return push_placeholder(
        state, type,
        fmt::format("{} takes one table, e.g. trocar.{} {{ name = \"a_name\" }}", type, type));
  lua_settop(state, 1);
  return construct(state, type);
}

int trocar_index(lua_State* state) {
  const std::string name = luaL_checkstring(state, 2);
  const Registry& registry = context(state).graph().registry();
  if (registry.find(name) != nullptr) {
    lua_pushstring(state, name.c_str());
    lua_pushcclosure(state, guarded<construct_closure>, 1);
    return 1;
  }
  std::vector<std::string> known = registry.names();
  lua_pushnil(state);
  while (lua_next(state, 1) != 0) {
    lua_pop(state, 1);
    if (lua_type(state, -1) == LUA_TSTRING) known.emplace_back(lua_tostring(state, -1));
  }
  return push_placeholder(state, name,
                          fmt::format("there is no trocar.{}{}", name, suggestion(name, known)));
}

// --- outputs, inputs, sites, parameters ---------------------------------------------------------

int output_to(lua_State* state) {
  Graph& graph = context(state).graph();
  const auto* output = get<OutputRef>(state, 1);
  for (int i = 2; i <= lua_gettop(state); ++i) {
    if (const auto* input = get<InputRef>(state, i))
      graph.connect(*output, *input, where(state));
    else if (get<Placeholder>(state, i) == nullptr) {
      graph.finding(where(state),
                    fmt::format("{}:to({}): an input is needed", signal_name(graph, *output),
                                luaL_tolstring(state, i, nullptr)));
      lua_pop(state, 1);
    }
  }
  lua_settop(state, 1);
  return 1;
}

int output_as(lua_State* state) {
  ScriptContext& script = context(state);
  const auto* output = get<OutputRef>(state, 1);
  const std::string name = luaL_checkstring(state, 2);
  if (const std::string wrong = script.graph().rename(output->node, name, script.scope());
      !wrong.empty())
    script.graph().finding(where(state), wrong);
  lua_settop(state, 1);
  return 1;
}

int output_delay(lua_State* state) {
  Graph& graph = context(state).graph();
  const OutputRef output = *get<OutputRef>(state, 1);
  luaL_checktype(state, 2, LUA_TTABLE);
  lua_settop(state, 2);
  construct(state, "Delay");
  if (const auto* delay = get<NodeRef>(state, -1)) {
    graph.connect(output, {delay->node, "input"}, where(state));
    push(state, OutputRef{delay->node, "value", ""});
  }
  return 1;
}

int output_index(lua_State* state) {
  const OutputRef output = *get<OutputRef>(state, 1);
  const std::string name = luaL_checkstring(state, 2);
  if (luaL_getmetafield(state, 1, "__methods") != LUA_TNIL) {
    lua_getfield(state, -1, name.c_str());
    if (!lua_isnil(state, -1)) return 1;
    lua_pop(state, 2);
  }
  OutputRef field = output;
  field.path += (field.path.empty() ? "" : ".") + name;
  const Graph& graph = context(state).graph();
  const auto& signature = graph.node(output.node).component->find_output(output.port)->signature();
  if (signature) {
    try {
      select_field(*signature, field.path);
    } catch (const std::invalid_argument& error) {
      return push_placeholder(state, name,
                              fmt::format("{}: {}", signal_name(graph, output), error.what()));
    }
  }
  push(state, field);
  return 1;
}

int site_index(lua_State* state) {
  const SiteRef site = *get<SiteRef>(state, 1);
  const std::string name = luaL_checkstring(state, 2);
  if (name == "position") {
    push(state, site.site.position);
  } else if (name == "velocity") {
    push(state, site.site.velocity);
  } else if (name == "force" && site.site.force) {
    push(state, *site.site.force);
  } else if (name == "moment" && site.site.moment) {
    push(state, *site.site.moment);
  } else if (name == "load" && site.site.load) {
    push(state, *site.site.load);
  } else {
    return push_placeholder(
        state, name,
        fmt::format("the site {} has no \"{}\"{}", site.name, name,
                    suggestion(name, {"position", "velocity", "force", "moment", "load"})));
  }
  return 1;
}

int to_string(lua_State* state) {
  const Graph& graph = context(state).graph();
  std::string text = "something";
  if (const auto* node = get<NodeRef>(state, 1))
    text = fmt::format("the component {}", graph.node(node->node).name);
  else if (const auto* output = get<OutputRef>(state, 1))
    text = "the output " + signal_name(graph, *output);
  else if (const auto* input = get<InputRef>(state, 1))
    text = fmt::format("the input {}.{}", graph.node(input->node).name, input->port);
  else if (const auto* parameter = get<ParameterRef>(state, 1))
    text = fmt::format("the parameter {}.{}", graph.node(parameter->node).name, parameter->name);
  else if (const auto* site = get<SiteRef>(state, 1))
    text = "the site " + site->name;
  else if (const auto* placeholder = get<Placeholder>(state, 1))
    text = placeholder->what + " (which does not exist)";
  lua_pushstring(state, text.c_str());
  return 1;
}

int refuse_assignment(lua_State* state) {
  context(state).graph().finding(
      where(state),
      fmt::format("{} cannot be assigned to: give \"{}\" in the constructor's table",
                  luaL_tolstring(state, 1, nullptr), luaL_tolstring(state, 2, nullptr)));
  return 0;
}

int same_placeholder(lua_State* state) {
  for (int i = 1; i <= lua_gettop(state); ++i) {
    if (get<Placeholder>(state, i) == nullptr) continue;
    lua_pushvalue(state, i);
    return 1;
  }
  return 0;
}

int no_field(lua_State* state) {
  return push_placeholder(
      state, lua_tostring(state, 2),
      fmt::format("{} has no \"{}\"", luaL_tolstring(state, 1, nullptr), lua_tostring(state, 2)));
}

}  // namespace

void apply_entry(lua_State* state, NodeId id, const std::string& key) {
  Graph& graph = context(state).graph();
  if (key == "name") return;
  // A declared parameter wins: a Step has a time that it calls "at", a Sine an angle "phase".
  const bool declared = graph.node(id).settings().find_parameter(key) != nullptr;
  if (key == "at" && !declared) return place_at(state, id);
  if ((key == "rate" || key == "phase") && !declared) return set_rate(state, id, key);
  const std::size_t dot = key.find('.');
  const Graph::Node& node = graph.node(id);
  if (dot != std::string::npos) {
    const auto part = node.exports.parts.find(key.substr(0, dot));
    if (part != node.exports.parts.end())
      return apply_entry(state, part->second, key.substr(dot + 1));
  }
  if (node.settings().find_parameter(key) != nullptr) return set_parameter(state, {id, key});
  if (node.component && node.component->find_input(key) != nullptr)
    return connect_value(state, {id, key});
  if (const auto input = node.exports.inputs.find(key); input != node.exports.inputs.end())
    return connect_value(state, input->second);
  std::vector<std::string> known = node.settings().parameter_names();
  if (node.component)
    for (const InputPort* port : node.component->inputs()) known.push_back(port->name());
  for (const auto& each : node.exports.inputs) known.push_back(each.first);
  for (const char* common : {"name", "at", "rate", "phase"}) known.emplace_back(common);
  graph.finding(where(state), fmt::format("{} (a {}) has no input or parameter \"{}\"{}", node.name,
                                          type_of(node), key, suggestion(key, known)));
}

int construct(lua_State* state, const std::string& type) {
  ScriptContext& script = context(state);
  Graph& graph = script.graph();
  const int table = lua_absindex(state, -1);
  const auto id = graph.add(type, given_name(state), where(state), script.scope());
  if (!id) {
    push(state, Placeholder{type});
    return 1;
  }
  const bool group = graph.node(*id).is_group();
  const std::vector<Key> keys = ordered_keys(state, table);
  // A group's parameters come before its parts exist, all the rest after.
  for (const bool before : {true, false}) {
    for (const Key& key : keys) {
      const bool parameter =
          group && graph.node(*id).settings().find_parameter(key.text) != nullptr;
      if (key.number > 0) {
        if (before)
          graph.finding(where(state), fmt::format("{}: entry {} of the table has no name",
                                                  graph.node(*id).name, key.number));
        continue;
      }
      if ((group && parameter) != before) continue;
      push_value(state, table, key);
      apply_entry(state, *id, key.text);
      lua_pop(state, 1);
    }
    if (group && before) graph.build_group(*id);
  }
  push(state, NodeRef{*id});
  return 1;
}

std::string signal_name(const Graph& graph, const OutputRef& output) {
  std::string name = graph.node(output.node).name + "." + output.port;
  if (!output.path.empty()) name += "." + output.path;
  return name;
}

int push_placeholder(lua_State* state, const std::string& what, const std::string& finding) {
  context(state).graph().finding(where(state), finding);
  push(state, Placeholder{what});
  return 1;
}

void open_graph(lua_State* state) {
  const luaL_Reg node[] = {{"__index", guarded<node_index>},
                           {"__newindex", guarded<refuse_assignment>},
                           {"__tostring", guarded<to_string>},
                           {nullptr, nullptr}};
  make_metatable<NodeRef>(state, node);
  const luaL_Reg output[] = {{"__index", guarded<output_index>},
                             {"__newindex", guarded<refuse_assignment>},
                             {"__tostring", guarded<to_string>},
                             {nullptr, nullptr}};
  make_metatable<OutputRef>(state, output);
  const luaL_Reg methods[] = {{"to", guarded<output_to>},
                              {"as", guarded<output_as>},
                              {"delay", guarded<output_delay>},
                              {nullptr, nullptr}};
  luaL_getmetatable(state, Meta<OutputRef>::name);
  luaL_newlib(state, methods);
  lua_setfield(state, -2, "__methods");
  lua_pop(state, 1);
  const luaL_Reg plain[] = {{"__index", guarded<no_field>},
                            {"__newindex", guarded<refuse_assignment>},
                            {"__tostring", guarded<to_string>},
                            {nullptr, nullptr}};
  make_metatable<InputRef>(state, plain);
  make_metatable<ParameterRef>(state, plain);
  const luaL_Reg site[] = {{"__index", guarded<site_index>},
                           {"__newindex", guarded<refuse_assignment>},
                           {"__tostring", guarded<to_string>},
                           {nullptr, nullptr}};
  make_metatable<SiteRef>(state, site);
  const luaL_Reg placeholder[] = {{"__index", guarded<same_placeholder>},
                                  {"__call", guarded<same_placeholder>},
                                  {"__add", guarded<same_placeholder>},
                                  {"__sub", guarded<same_placeholder>},
                                  {"__mul", guarded<same_placeholder>},
                                  {"__div", guarded<same_placeholder>},
                                  {"__unm", guarded<same_placeholder>},
                                  {"__concat", guarded<same_placeholder>},
                                  {"__tostring", guarded<to_string>},
                                  {"__newindex", [](lua_State*) { return 0; }},
                                  {nullptr, nullptr}};
  make_metatable<Placeholder>(state, placeholder);

  lua_newtable(state);
  lua_pushcfunction(state, guarded<trocar_index>);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
}

}  // namespace trocar::lua
