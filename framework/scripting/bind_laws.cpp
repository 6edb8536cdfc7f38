// SPDX-License-Identifier: Apache-2.0
// trocar.LuaFixture and trocar.LuaComponent: components that files define.
#include <fmt/format.h>

#include "framework/scripting/lua_component.hpp"
#include "framework/scripting/script_context.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

struct LawConstructor {
  const char* name;
  LawKind kind;
  const char* example;
};

constexpr LawConstructor constructors[] = {
    {"LuaFixture", LawKind::fixture, "{ file = \"membrane.lua\", at = laparoscope.tip }"},
    {"LuaComponent", LawKind::component, "{ file = \"blend.lua\" }"},
};

const LawConstructor* find_constructor(std::string_view name) {
  for (const LawConstructor& one : constructors)
    if (name == one.name) return &one;
  return nullptr;
}

/// The file's name out of the table at 1; nothing, and a finding, where there is none.
std::optional<std::string> given_file(lua_State* state, const LawConstructor& constructor) {
  lua_getfield(state, 1, "file");
  const Literal given = to_literal(state, -1);
  lua_pop(state, 1);
  if (const auto* name = given.as<std::string>()) return *name;
  context(state).graph().finding(
      where(state), fmt::format("{} needs its file, e.g. trocar.{} {}", constructor.name,
                                constructor.name, constructor.example));
  return std::nullopt;
}

std::shared_ptr<const LawFile> read_given(lua_State* state, const LawConstructor& constructor,
                                          const std::string& name) {
  ScriptContext& script = context(state);
  const std::filesystem::path path = script.folder / name;
  auto text = read_file(path);
  if (!text) {
    script.graph().finding(where(state),
                           fmt::format("file = \"{}\": there is no file {} that can be read; it is "
                                       "looked for beside the script",
                                       name, path.string()));
    return nullptr;
  }
  script.session.add_script(name, *text);
  const std::string shown = std::filesystem::path(name).filename().string();
  Findings findings;
  auto file = read_law(constructor.kind, shown, path.string(), std::move(*text), findings);
  for (const Finding& finding : findings.all())
    script.graph().finding(finding.where, finding.message);
  return file;
}

/// What stands for a component that could not be made; nothing more is said about it.
int give_up(lua_State* state, const std::string& what) {
  push(state, Placeholder{what});
  return 1;
}

}  // namespace

int construct_law(lua_State* state, const std::string& type) {
  const LawConstructor& constructor = *find_constructor(type);
  ScriptContext& script = context(state);
  if (!lua_istable(state, 1))
    return push_placeholder(
        state, type,
        fmt::format("{} takes one table, e.g. trocar.{} {}", type, type, constructor.example));
  lua_settop(state, 1);
  const auto name = given_file(state, constructor);
  if (!name) return give_up(state, type);
  auto file = read_given(state, constructor, *name);
  if (!file) return give_up(state, type);
  const std::string stem = std::filesystem::path(*name).stem().string();
  const std::string own = given_name(state, 1, is_name(stem) ? stem : snake_case(type));
  const ThreadScope scope(script.graph(), thread_given(state, 1));
  const auto id = script.graph().add(law_type(std::move(file)), own, where(state), script.scope());
  if (!id) return give_up(state, own);
  lua_pushnil(state);
  lua_setfield(state, 1, "file");
  return apply_entries(state, *id);
}

bool is_law(const std::string& type) {
  return find_constructor(type) != nullptr;
}

namespace {

int construct_law_closure(lua_State* state) {
  return construct_law(state, lua_tostring(state, lua_upvalueindex(1)));
}

}  // namespace

void open_laws(lua_State* state) {
  for (const LawConstructor& one : constructors) {
    lua_pushstring(state, one.name);
    lua_pushcclosure(state, guarded<construct_law_closure>, 1);
    lua_setfield(state, -2, one.name);
  }
}

}  // namespace trocar::lua
