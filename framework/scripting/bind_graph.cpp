// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "framework/component_definition.hpp"
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

bool starts_a_name(const Component& component, const std::string& prefix) {
  return std::any_of(component.outputs().begin(), component.outputs().end(),
                     [&](const OutputPort* port) { return port->name().starts_with(prefix); });
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
  else if (const auto part = exports.parts.find(name); part != exports.parts.end())
    push(state, NodeRef{part->second});  // before a parameter that says of which kind it is
  else if (node.settings().find_parameter(name) != nullptr)
    push(state, ParameterRef{id, name});
  else if (node.component && node.component->find_input(name) != nullptr)
    push(state, InputRef{id, name});
  else if (node.component && starts_a_name(*node.component, name + "."))
    push(state, PortGroupRef{id, name + "."});
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

int port_group_index(lua_State* state) {
  const Graph& graph = context(state).graph();
  const PortGroupRef& ports = *get<PortGroupRef>(state, 1);
  const std::string name = ports.prefix + luaL_checkstring(state, 2);
  if (push_member(state, graph, ports.node, name)) return 1;
  const Graph::Node& node = graph.node(ports.node);
  return push_placeholder(state, node.name + "." + name,
                          fmt::format("{} (a {}) has no \"{}\"{}", node.name, type_of(node), name,
                                      suggestion(name, member_names(node))));
}

// --- constructing -----------------------------------------------------------------------------

void connect_literal(lua_State* state, NodeId node, const std::string& input) {
  Graph& graph = context(state).graph();
  const Where at = where(state);
  const std::string owner = graph.node(node).name;  // its signal is "wall.offset.value"
  const ThreadScope scope(graph, graph.node(node).thread);
  const auto constant = graph.add("Constant", context(state).unused_name(input, owner), at, owner);
  if (!constant) return;
  graph.set({*constant, "value"}, to_literal(state, -1), at);
  graph.connect({*constant, "value", ""}, {node, input}, at);
}

void connect_one(lua_State* state, const InputRef& input) {
  Graph& graph = context(state).graph();
  if (const auto* output = get<OutputRef>(state, -1)) {
    graph.connect(*output, input, where(state));
  } else if (get<Placeholder>(state, -1) != nullptr) {
    graph.node(input.node).set_at[input.port] = where(state);
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

void connect_value(lua_State* state, const InputRef& input) {
  const Graph::Node& node = context(state).graph().node(input.node);
  if (!lua_istable(state, -1) || !node.component->find_input(input.port)->variadic())
    return connect_one(state, input);
  const int list = lua_absindex(state, -1);
  for (const Key& key : ordered_keys(state, list)) {
    push_value(state, list, key);
    connect_one(state, input);
    lua_pop(state, 1);
  }
}

/// Outputs in a value become their signals' names: signals = { wall.force }.
Literal literal_with_signals(lua_State* state, int index, int depth = 0) {
  const int at = lua_absindex(state, index);
  if (const auto* output = get<OutputRef>(state, at))
    return {signal_name(context(state).graph(), *output)};
  if (const auto* node = get<NodeRef>(state, at))
    return {context(state).graph().node(node->node).name};
  if (!lua_istable(state, at) || depth > 4) return to_literal(state, at);
  Literal::List list;
  for (const Key& key : ordered_keys(state, at)) {
    if (key.number == 0) return to_literal(state, at);
    push_value(state, at, key);
    list.push_back(literal_with_signals(state, -1, depth + 1));
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

std::optional<double> rate_of(const std::string& text) {
  try {
    const Quantity rate = parse_quantity(text);
    if (rate.unit.dimension == parse_unit("Hz").dimension && rate.value > 0.0) return rate.value;
  } catch (const UnitError&) {
  }
  return std::nullopt;
}

void set_rate(lua_State* state, NodeId node, const std::string& key) {
  Graph& graph = context(state).graph();
  const Graph::Node& known = graph.node(node);
  if (get<Placeholder>(state, -1) != nullptr) return;
  const Literal value = to_literal(state, -1);
  if (known.is_group()) {
    graph.finding(where(state),
                  fmt::format("{} is a group: give \"{}\" to its components", known.name, key));
  } else if (key == "phase") {
    if (lua_isinteger(state, -1))
      return graph.set_rate(node, known.rate, lua_tointeger(state, -1), where(state));
    graph.finding(where(state), fmt::format("{}.phase = {}: needs a whole number of ticks",
                                            known.name, value.text()));
  } else {
    const auto* written = value.as<std::string>();
    const auto rate = written == nullptr ? std::nullopt : rate_of(*written);
    if (rate) return graph.set_rate(node, *rate, known.phase, where(state));
    graph.finding(where(state), fmt::format("{}.rate = {}: needs Hz, above 0, e.g. \"100 Hz\"",
                                            known.name, value.text()));
  }
}

std::vector<const InputPort*> placed_inputs(const Graph::Node& node) {
  std::vector<const InputPort*> inputs;
  if (!node.component || !node.component->placement()) return inputs;
  const Placement& placement = *node.component->placement();
  if (placement.position != nullptr) inputs.push_back(placement.position);
  if (placement.velocity != nullptr) inputs.push_back(placement.velocity);
  return inputs;
}

void place_at(lua_State* state, NodeId node) {
  Graph& graph = context(state).graph();
  if (const auto* site = get<SiteRef>(state, -1))
    return graph.place(node, site->site, where(state));
  for (const InputPort* input : placed_inputs(graph.node(node)))
    graph.node(node).set_at[input->name()] = where(state);  // no second finding about them
  if (get<Placeholder>(state, -1) != nullptr) return;
  graph.finding(where(state),
                fmt::format("{}: at = {} is no site, e.g. at = laparoscope.tip",
                            graph.node(node).name, luaL_tolstring(state, -1, nullptr)));
  lua_pop(state, 1);
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

/// The entry that a component's ports follow from.
bool defines(const Graph::Node& node, const std::string& key) {
  return node.type != nullptr && node.type->definition && node.type->definition->entry == key;
}

}  // namespace

void apply_entry(lua_State* state, NodeId id, const std::string& key) {
  Graph& graph = context(state).graph();
  if (key == "name" || defines(graph.node(id), key)) return;  // construct() has seen it
  // A declared parameter wins: a Step has a time that it calls "at", a Sine an angle "phase".
  const bool declared = graph.node(id).settings().find_parameter(key) != nullptr;
  if (key == "thread" && !declared) return;  // construct() has seen it
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
  for (const char* common : {"name", "at", "rate", "phase", "thread"}) known.emplace_back(common);
  if (node.type != nullptr && node.type->definition) known.push_back(node.type->definition->entry);
  graph.finding(where(state), fmt::format("{} (a {}) has no input or parameter \"{}\"{}", node.name,
                                          type_of(node), key, suggestion(key, known)));
}

std::string given_name(lua_State* state, int table, const std::string& spare) {
  lua_getfield(state, table, "name");
  const Literal given = to_literal(state, -1);
  lua_pop(state, 1);
  if (given.as<std::monostate>() != nullptr) return spare;
  if (const auto* name = given.as<std::string>()) return *name;
  context(state).graph().finding(where(state),
                                 fmt::format("name = {}: needs a text", given.text()));
  return spare;
}

void refuse_odd_keys(lua_State* state, int table, const std::string& owner) {
  lua_pushnil(state);
  while (lua_next(state, table) != 0) {
    lua_pop(state, 1);
    if (lua_type(state, -1) == LUA_TSTRING) continue;
    lua_pushvalue(state, -1);
    context(state).graph().finding(where(state),
                                   fmt::format("{}: entry [{}] of the table has no name", owner,
                                               luaL_tolstring(state, -1, nullptr)));
    lua_pop(state, 2);
  }
}

int construct(lua_State* state, const std::string& type, const std::string& spare_name) {
  ScriptContext& script = context(state);
  Graph& graph = script.graph();
  const int table = lua_absindex(state, -1);
  const ThreadScope scope(graph, thread_given(state, table));
  const std::string name = given_name(state, table, spare_name);
  const ComponentType* known = graph.registry().find(type);
  const auto id = known != nullptr && known->definition != nullptr
                      ? add_defined(state, table, *known, name)
                      : graph.add(type, name, where(state), script.scope());
  if (!id) {
    push(state, Placeholder{type});
    return 1;
  }
  lua_pushvalue(state, table);
  return apply_entries(state, *id);
}

int apply_entries(lua_State* state, NodeId node) {
  Graph& graph = context(state).graph();
  const NodeId* id = &node;
  const int table = lua_gettop(state);
  const bool group = graph.node(*id).is_group();
  refuse_odd_keys(state, table, graph.node(*id).name);
  const std::vector<Key> keys = ordered_keys(state, table);
  // A group's parameters come before its parts exist, all the rest after.
  for (const bool before : {true, false}) {
    for (const Key& key : keys) {
      const bool parameter =
          group && graph.node(*id).settings().find_parameter(key.text) != nullptr;
      if (key.number > 0) continue;
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

int push_placeholder(lua_State* state, const std::string& what, const std::string& finding) {
  context(state).graph().finding(where(state), finding);
  push(state, Placeholder{what});
  return 1;
}

void open_graph(lua_State* state) {
  const luaL_Reg node[] = {{"__index", guarded<node_index>}, {nullptr, nullptr}};
  make_metatable<NodeRef>(state, node);
  const luaL_Reg ports[] = {{"__index", guarded<port_group_index>}, {nullptr, nullptr}};
  make_metatable<PortGroupRef>(state, ports);
  open_signals(state);

  lua_newtable(state);
  lua_pushcfunction(state, guarded<trocar_index>);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
}

}  // namespace trocar::lua
