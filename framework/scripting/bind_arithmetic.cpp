// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "framework/scripting/script_context.hpp"

namespace trocar::lua {
namespace {

/// What an operator makes belongs to the thread of an operand that comes from no other thread.
std::optional<ThreadId> thread_of_operands(lua_State* state) {
  const Graph& graph = context(state).graph();
  bool any_output = false;
  for (const int operand : {1, 2}) {
    const auto* output = get<OutputRef>(state, operand);
    if (output != nullptr && !output->connection) return graph.node(output->node).thread;
    any_output = any_output || output != nullptr;
  }
  return any_output ? std::nullopt : std::optional(graph.current_thread());
}

/// Adds a nameless generic component; names are given by `:as`, else "sum", "sum_2", ….
std::optional<NodeId> add_operator(lua_State* state, const std::string& type,
                                   const std::string& stem) {
  ScriptContext& script = context(state);
  const auto thread = thread_of_operands(state);
  if (!thread) {
    script.graph().finding(
        where(state), fmt::format("in which thread is this {} to be? Say it by its component, e.g. "
                                  "servo.{} {{ … }}",
                                  stem, type));
    return std::nullopt;
  }
  const ThreadScope scope(script.graph(), *thread);
  const auto node =
      script.graph().add(type, script.unused_name(stem), where(state), script.scope());
  if (node) script.nameless.insert(*node);
  return node;
}

int push_nothing(lua_State* state, const char* what) {
  push(state, Placeholder{what});
  return 1;
}

/// Wires operand `index` to the input: an output, or a value by way of a constant.
void wire_operand(lua_State* state, int index, NodeId node, const std::string& input) {
  lua_pushvalue(state, index);
  apply_entry(state, node, input);
  lua_pop(state, 1);
}

bool is_placeholder(lua_State* state, int index) {
  return get<Placeholder>(state, index) != nullptr;
}

int combine(lua_State* state, const std::string& second_input) {
  for (const int operand : {1, 2}) {
    if (!is_placeholder(state, operand)) continue;
    lua_pushvalue(state, operand);
    return 1;
  }
  const auto node = add_operator(state, "Sum", "sum");
  if (!node) return push_nothing(state, "sum");
  wire_operand(state, 1, *node, "terms");
  wire_operand(state, 2, *node, second_input);
  push(state, OutputRef{*node, "value", ""});
  return 1;
}

int add(lua_State* state) {
  return combine(state, "terms");
}
int subtract(lua_State* state) {
  return combine(state, "minus");
}

int scale_by(lua_State* state, int output, const Literal& factor) {
  const auto node = add_operator(state, "Scale", "scale");
  if (!node) return push_nothing(state, "scale");
  wire_operand(state, output, *node, "input");
  context(state).graph().set({*node, "factor"}, factor, where(state));
  push(state, OutputRef{*node, "value", ""});
  return 1;
}

int multiply(lua_State* state) {
  for (const int operand : {1, 2}) {
    if (!is_placeholder(state, operand)) continue;
    lua_pushvalue(state, operand);
    return 1;
  }
  const bool first = get<OutputRef>(state, 1) != nullptr;
  const bool second = get<OutputRef>(state, 2) != nullptr;
  if (first && second) {
    const auto node = add_operator(state, "Product", "product");
    if (!node) return push_nothing(state, "product");
    wire_operand(state, 1, *node, "factor");
    wire_operand(state, 2, *node, "input");
    push(state, OutputRef{*node, "value", ""});
    return 1;
  }
  return scale_by(state, first ? 1 : 2, to_literal(state, first ? 2 : 1));
}

int negate(lua_State* state) {
  return scale_by(state, 1, {-1.0});
}

}  // namespace

void open_arithmetic(lua_State* state) {
  const luaL_Reg operators[] = {{"__add", guarded<add>},
                                {"__sub", guarded<subtract>},
                                {"__mul", guarded<multiply>},
                                {"__unm", guarded<negate>},
                                {nullptr, nullptr}};
  luaL_getmetatable(state, Meta<OutputRef>::name);
  luaL_setfuncs(state, operators, 0);
  lua_pop(state, 1);
}

}  // namespace trocar::lua
