// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "framework/scripting/run_options.hpp"
#include "framework/scripting/script_context.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

int whole_number_in(const Literal& value, const std::string& what) {
  const auto* number = value.as<double>();
  if (number == nullptr || std::floor(*number) != *number || std::abs(*number) > 1e6)
    throw std::invalid_argument(fmt::format("{} = {}: needs a whole number", what, value.text()));
  return static_cast<int>(*number);
}

Graph::Thread read_thread(lua_State* state, std::string& name) {
  Graph::Thread thread{.name = {}, .where = where(state)};
  for (const Key& key : ordered_keys(state, 1)) {
    push_value(state, 1, key);
    const Literal value = to_literal(state, -1);
    lua_pop(state, 1);
    const std::string what = "thread." + key.text;
    if (key.text == "name") {
      const auto* text = value.as<std::string>();
      if (text == nullptr || !is_name(*text))
        throw std::invalid_argument(
            fmt::format("{} = {}: needs letters, digits and underscores, starting with a letter",
                        what, value.text()));
      name = *text;
    } else if (key.text == "rate") {
      thread.rate = quantity(value, "Hz", what);
    } else if (key.text == "phase") {
      thread.phase = quantity(value, "s", what);
    } else if (key.text == "priority") {
      thread.priority = whole_number_in(value, what);
    } else if (key.text == "processor") {
      thread.processor = whole_number_in(value, what);
    } else {
      throw std::invalid_argument(
          fmt::format("trocar.thread has no \"{}\"{}", key.text,
                      suggestion(key.text, {"name", "rate", "phase", "priority", "processor"})));
    }
  }
  return thread;
}

/// trocar.thread { rate = "1 kHz", priority = 80, processor = 1, phase = "0.5 ms" }
int make_thread(lua_State* state) {
  if (!lua_istable(state, 1))
    throw std::invalid_argument("trocar.thread takes one table, e.g. { rate = \"1 kHz\" }");
  ScriptContext& script = context(state);
  std::string name;
  Graph::Thread thread = read_thread(state, name);
  if (thread.rate == 0.0)
    throw std::invalid_argument("trocar.thread needs a rate, e.g. { rate = \"1 kHz\" }");
  const auto taken = [&](const std::string& other) {
    for (const Graph::Thread& one : script.graph().threads())
      if (one.name == other) return true;
    return false;
  };
  thread.name = name.empty() ? "thread" : name;
  for (int n = 2; name.empty() && taken(thread.name); ++n)
    thread.name = fmt::format("thread_{}", n);
  if (!name.empty() && taken(name))
    throw std::invalid_argument(fmt::format("there is a thread \"{}\" already", name));
  const ThreadId id = script.graph().add_thread(std::move(thread));
  if (name.empty()) script.nameless_threads.insert(id);
  push(state, ThreadRef{id});
  return 1;
}

/// The name of the local variable, upvalue or global that holds the value at `index`.
std::string variable_of(lua_State* state, int index) {
  const int value = lua_absindex(state, index);
  const auto found = [&](const char* name) {
    const bool same = name != nullptr && name[0] != '(' && lua_rawequal(state, -1, value) != 0;
    if (name != nullptr) lua_pop(state, 1);
    return same;
  };
  lua_Debug frame;
  for (int level = 0; lua_getstack(state, level, &frame) != 0; ++level) {
    const char* name = nullptr;
    for (int i = 1; (name = lua_getlocal(state, &frame, i)) != nullptr; ++i)
      if (found(name)) return name;
    lua_getinfo(state, "f", &frame);
    for (int i = 1; (name = lua_getupvalue(state, -1, i)) != nullptr; ++i)
      if (found(name)) {
        lua_pop(state, 1);
        return name;
      }
    lua_pop(state, 1);
  }
  lua_pushglobaltable(state);
  for (const Key& key : ordered_keys(state, -1)) {
    push_value(state, -1, key);
    if (found(key.text.c_str())) {
      lua_pop(state, 1);
      return key.text;
    }
  }
  lua_pop(state, 1);
  return "";
}

/// A thread without a name takes that of the variable through which it is first used.
void name_thread(lua_State* state, ThreadId thread) {
  ScriptContext& script = context(state);
  if (script.nameless_threads.erase(thread) == 0) return;
  if (const std::string name = variable_of(state, 1); !name.empty())
    script.graph().rename_thread(thread, name);
}

int construct_in_thread(lua_State* state) {
  const auto thread = static_cast<ThreadId>(lua_tointeger(state, lua_upvalueindex(2)));
  const ThreadScope scope(context(state).graph(), thread);
  const std::string type = lua_tostring(state, lua_upvalueindex(1));
  if (!lua_istable(state, 1))
    return push_placeholder(
        state, type,
        fmt::format("{} takes one table, e.g. {} {{ name = \"a_name\" }}", type, type));
  lua_settop(state, 1);
  return is_law(type) ? construct_law(state, type) : construct(state, type);
}

int thread_index(lua_State* state) {
  const ThreadId thread = get<ThreadRef>(state, 1)->thread;
  const std::string name = luaL_checkstring(state, 2);
  const Graph& graph = context(state).graph();
  name_thread(state, thread);
  if (graph.registry().find(name) != nullptr || is_law(name)) {
    lua_pushstring(state, name.c_str());
    lua_pushinteger(state, static_cast<lua_Integer>(thread));
    lua_pushcclosure(state, guarded<construct_in_thread>, 2);
    return 1;
  }
  return push_placeholder(
      state, name,
      fmt::format("there is no component \"{}\"{}; a group of your own takes thread = {}", name,
                  suggestion(name, graph.registry().names()), graph.threads()[thread].name));
}

Connection read_connection(lua_State* state, Connection::Kind kind) {
  Connection connection{.kind = kind};
  if (lua_isnoneornil(state, 2)) return connection;
  const std::string method = to_string(kind);
  if (!lua_istable(state, 2))
    throw std::invalid_argument(
        method + " takes a table, e.g. :" + method +
        (kind == Connection::Kind::latest ? " { stale = \"5 ms\" }" : " { size = 64 }"));
  for (const Key& key : ordered_keys(state, 2)) {
    push_value(state, 2, key);
    const Literal value = to_literal(state, -1);
    lua_pop(state, 1);
    if (key.text == "stale") {
      connection.stale = quantity(value, "s", "stale");
      if (!(connection.stale > 0.0))
        throw std::invalid_argument(fmt::format("stale = {}: needs more than 0 s", value.text()));
    } else if (key.text == "size" && kind == Connection::Kind::queue) {
      const int size = whole_number_in(value, "size");
      if (size < 1 || size > 100'000)
        throw std::invalid_argument(fmt::format("size = {}: 1 to 100000 is possible", size));
      connection.size = static_cast<std::size_t>(size);
    } else {
      throw std::invalid_argument(fmt::format("{} has no \"{}\"{}", method, key.text,
                                              suggestion(key.text, {"stale", "size"})));
    }
  }
  return connection;
}

}  // namespace

template <Connection::Kind kind>
int output_across(lua_State* state) {
  OutputRef output = self<OutputRef>(
      state, kind == Connection::Kind::latest ? "wall.load:latest()" : "wall.load:queue()");
  output.connection = read_connection(state, kind);
  push(state, std::move(output));
  return 1;
}

int output_latest(lua_State* state) {
  return output_across<Connection::Kind::latest>(state);
}
int output_queue(lua_State* state) {
  return output_across<Connection::Kind::queue>(state);
}

ThreadId thread_given(lua_State* state, int table) {
  Graph& graph = context(state).graph();
  lua_getfield(state, table, "thread");
  ThreadId thread = graph.current_thread();
  if (const auto* given = get<ThreadRef>(state, -1)) {
    thread = given->thread;
    if (context(state).nameless_threads.erase(thread) > 0)
      if (const std::string name = variable_of(state, -1); !name.empty())
        graph.rename_thread(thread, name);
  } else if (!lua_isnil(state, -1) && get<Placeholder>(state, -1) == nullptr) {
    graph.finding(where(state), fmt::format("thread = {}: needs what trocar.thread returned",
                                            to_literal(state, -1).text()));
  }
  lua_pop(state, 1);
  return thread;
}

void open_threads(lua_State* state) {
  lua_pushcfunction(state, guarded<make_thread>);
  lua_setfield(state, -2, "thread");
  const luaL_Reg thread[] = {{"__index", guarded<thread_index>}, {nullptr, nullptr}};
  make_metatable<ThreadRef>(state, thread);
  complete_metatable(state, Meta<ThreadRef>::name);
}

}  // namespace trocar::lua
