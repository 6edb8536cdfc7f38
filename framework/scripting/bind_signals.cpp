// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "framework/scripting/script_context.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

int output_to(lua_State* state) {
  Graph& graph = context(state).graph();
  const auto* output = &self<OutputRef>(state, "wall.force:to(input)");
  if (lua_gettop(state) < 2)
    graph.finding(where(state),
                  fmt::format("{}:to(): to which input?", signal_name(graph, *output)));
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
  const auto* output = &self<OutputRef>(state, "(a + b):as \"name\"");
  if (lua_type(state, 2) != LUA_TSTRING)
    throw std::invalid_argument("as needs a name, e.g. (a + b):as \"surface\"");
  const std::string name = lua_tostring(state, 2);
  lua_settop(state, 1);
  if (!script.nameless.contains(output->node)) {
    script.graph().finding(
        where(state), fmt::format("{} has a name already: \"as\" names what +, -, * and delay make",
                                  signal_name(script.graph(), *output)));
    return 1;
  }
  if (const std::string wrong = script.graph().rename(output->node, name, script.scope());
      !wrong.empty())
    script.graph().finding(where(state), wrong);
  return 1;
}

int output_delay(lua_State* state) {
  Graph& graph = context(state).graph();
  const OutputRef output = self<OutputRef>(state, "wall.depth:delay { initial = \"0 mm\" }");
  if (!lua_istable(state, 2))
    throw std::invalid_argument("delay needs a table, e.g. :delay { initial = \"0 mm\" }");
  lua_settop(state, 2);
  if (output.connection)
    return push_placeholder(
        state, "delay",
        fmt::format("{}: delay it first, and let {} come last", signal_name(graph, output),
                    to_string(output.connection->kind)));
  const ThreadScope scope(graph, graph.node(output.node).thread);
  const std::string spare = context(state).unused_name("delay");
  construct(state, "Delay", spare);
  if (const auto* delay = get<NodeRef>(state, -1)) {
    if (graph.node(delay->node).name.ends_with(spare)) context(state).nameless.insert(delay->node);
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
  else if (const auto* ports = get<PortGroupRef>(state, 1))
    text = fmt::format("the outputs {}.{}*", graph.node(ports->node).name, ports->prefix);
  else if (const auto* thread = get<ThreadRef>(state, 1))
    text = "the thread " + graph.threads()[thread->thread].name;
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

/// Positions in it are empty, or ipairs would never end.
int index_placeholder(lua_State* state) {
  if (lua_type(state, 2) == LUA_TNUMBER) return 0;
  lua_settop(state, 1);
  return 1;
}

int no_field(lua_State* state) {
  const std::string owner = luaL_tolstring(state, 1, nullptr);
  const std::string name = luaL_tolstring(state, 2, nullptr);
  const bool method =
      name == "to" || name == "as" || name == "delay" || name == "latest" || name == "queue";
  return push_placeholder(
      state, name,
      fmt::format("{} has no \"{}\"{}", owner, name,
                  method ? fmt::format(": an output has, e.g. wall.force:{}(…)", name) : ""));
}

/// A placeholder passes through everything that is done to it, and ends every loop over it.
void open_placeholder(lua_State* state) {
  constexpr lua_CFunction same = guarded<same_placeholder>;
  const lua_CFunction is_false = [](lua_State* s) {
    lua_pushboolean(s, 0);
    return 1;
  };
  const luaL_Reg functions[] = {{"__index", guarded<index_placeholder>},
                                {"__call", same},
                                {"__add", same},
                                {"__sub", same},
                                {"__mul", same},
                                {"__div", same},
                                {"__idiv", same},
                                {"__mod", same},
                                {"__pow", same},
                                {"__unm", same},
                                {"__concat", same},
                                {"__lt", is_false},
                                {"__le", is_false},
                                {"__len",
                                 [](lua_State* s) {
                                   lua_pushinteger(s, 0);
                                   return 1;
                                 }},
                                {"__pairs",
                                 [](lua_State* s) {
                                   lua_pushcfunction(s, [](lua_State*) { return 0; });
                                   return 1;
                                 }},
                                {"__tostring", guarded<to_string>},
                                {"__newindex", [](lua_State*) { return 0; }},
                                {nullptr, nullptr}};
  make_metatable<Placeholder>(state, functions);
}

}  // namespace

std::string signal_name(const Graph& graph, const OutputRef& output) {
  std::string name = graph.node(output.node).name + "." + output.port;
  if (!output.path.empty()) name += "." + output.path;
  return name;
}

void complete_metatable(lua_State* state, const char* metatable) {
  const luaL_Reg common[] = {{"__newindex", guarded<refuse_assignment>},
                             {"__tostring", guarded<to_string>},
                             {nullptr, nullptr}};
  luaL_getmetatable(state, metatable);
  luaL_setfuncs(state, common, 0);
  lua_pop(state, 1);
}

void open_signals(lua_State* state) {
  const luaL_Reg output[] = {{"__index", guarded<output_index>}, {nullptr, nullptr}};
  make_metatable<OutputRef>(state, output);
  const luaL_Reg methods[] = {{"to", guarded<output_to>},       {"as", guarded<output_as>},
                              {"delay", guarded<output_delay>}, {"latest", guarded<output_latest>},
                              {"queue", guarded<output_queue>}, {nullptr, nullptr}};
  luaL_getmetatable(state, Meta<OutputRef>::name);
  luaL_newlib(state, methods);
  lua_setfield(state, -2, "__methods");
  lua_pop(state, 1);
  const luaL_Reg plain[] = {{"__index", guarded<no_field>}, {nullptr, nullptr}};
  make_metatable<InputRef>(state, plain);
  make_metatable<ParameterRef>(state, plain);
  const luaL_Reg site[] = {{"__index", guarded<site_index>}, {nullptr, nullptr}};
  make_metatable<SiteRef>(state, site);
  complete_metatable(state, Meta<NodeRef>::name);
  complete_metatable(state, Meta<PortGroupRef>::name);
  complete_metatable(state, Meta<OutputRef>::name);
  complete_metatable(state, Meta<InputRef>::name);
  complete_metatable(state, Meta<ParameterRef>::name);
  complete_metatable(state, Meta<SiteRef>::name);
  open_placeholder(state);
}

}  // namespace trocar::lua
