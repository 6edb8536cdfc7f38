// SPDX-License-Identifier: Apache-2.0
// Components whose ports follow from an entry of their table: a table, a file, or a shipped one.
#include <fmt/format.h>

#include <algorithm>

#include "framework/component_definition.hpp"
#include "framework/scripting/definition_file.hpp"
#include "framework/scripting/entry_lines.hpp"
#include "framework/scripting/script_context.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

struct DefinitionText {
  std::string path;
  std::string text;
};

/// A definition as the script gave it.
struct GivenDefinition {
  Literal value;
  std::optional<DefinitionText> file{};  // that it stands in
};

bool is_file(const std::string& given) {
  return given.ends_with(".lua") || given.find('/') != std::string::npos;
}

/// A file beside the script comes before a shipped one of its name.
std::optional<DefinitionText> find_text(const ScriptContext& script,
                                        const ComponentDefinition& definition,
                                        const std::string& given) {
  const std::filesystem::path path = script.folder / (is_file(given) ? given : given + ".lua");
  if (auto text = read_file(path)) return DefinitionText{path.string(), std::move(*text)};
  for (const ComponentDefinition::Shipped& shipped : definition.shipped)
    if (shipped.name == given) return DefinitionText{given + ".lua", shipped.text};
  return std::nullopt;
}

std::string not_found(const ScriptContext& script, const ComponentDefinition& definition,
                      const std::string& given) {
  if (is_file(given))
    return fmt::format(
        "{} = \"{}\": there is no file {} that can be read; it is looked for beside the script",
        definition.entry, given, (script.folder / given).string());
  std::vector<std::string> known;
  for (const ComponentDefinition::Shipped& shipped : definition.shipped)
    known.push_back(shipped.name);
  return fmt::format(
      "{} = \"{}\": there is neither a shipped {} of that name nor {}.lua beside the "
      "script{}",
      definition.entry, given, definition.entry, given, suggestion(given, known));
}

std::optional<GivenDefinition> read_file_given(lua_State* state,
                                               const ComponentDefinition& definition,
                                               const std::string& given) {
  ScriptContext& script = context(state);
  auto file = find_text(script, definition, given);
  if (!file) {
    script.graph().finding(where(state), not_found(script, definition, given));
    return std::nullopt;
  }
  script.session.add_script(is_file(given) ? given : given + ".lua", file->text);
  Findings findings;
  const std::string name = std::filesystem::path(file->path).filename().string();
  auto value = read_definition(name, file->path, file->text, findings);
  for (const Finding& finding : findings.all())
    script.graph().finding(finding.where, finding.message);
  if (!value) return std::nullopt;
  return GivenDefinition{std::move(*value), std::move(file)};
}

/// The entry of the table at `table`; nothing, and a finding, where it is none.
std::optional<GivenDefinition> read_entry(lua_State* state, int table, const ComponentType& type) {
  const ComponentDefinition& definition = *type.definition;
  Graph& graph = context(state).graph();
  lua_getfield(state, table, definition.entry.c_str());
  const int entry = lua_gettop(state);
  std::optional<GivenDefinition> given;
  if (lua_istable(state, entry)) {
    if (auto value = definition_at(state, entry))
      given = GivenDefinition{std::move(*value)};
    else
      graph.finding(where(state),
                    fmt::format("{}: the table is too large, or holds itself", definition.entry));
  } else if (lua_type(state, entry) == LUA_TSTRING) {
    given = read_file_given(state, definition, lua_tostring(state, entry));
  } else if (get<Placeholder>(state, entry) == nullptr) {
    const std::string example =
        fmt::format("trocar.{} {{ {} = {} }}", type.name, definition.entry, definition.example);
    graph.finding(
        where(state),
        lua_isnil(state, entry)
            ? fmt::format("{} needs its {}, e.g. {}", type.name, definition.entry, example)
            : fmt::format("{} = {}: needs a table or the name of a file, e.g. {}", definition.entry,
                          to_literal(state, entry).text(), example));
  }
  lua_settop(state, entry - 1);
  return given;
}

/// A mistake in a file is told with its line there, another one with the script's.
void add_mistake(lua_State* state, const GivenDefinition& given, const DefinitionMistake& mistake) {
  const std::string message =
      mistake.path.empty() ? mistake.message : join(mistake.path, ".") + ": " + mistake.message;
  const Where at = given.file
                       ? Where{given.file->path, line_of_entry(given.file->text, mistake.path)}
                       : where(state);
  context(state).graph().finding(at, message);
}

}  // namespace

std::optional<NodeId> add_defined(lua_State* state, int table, const ComponentType& type,
                                  const std::string& name) {
  ScriptContext& script = context(state);
  const auto given = read_entry(state, table, type);
  if (!given) return std::nullopt;
  std::vector<DefinitionMistake> mistakes;
  auto defined = defined_type(type, given->value, mistakes);
  for (const DefinitionMistake& mistake : mistakes) add_mistake(state, *given, mistake);
  if (!defined) return std::nullopt;
  return script.graph().add(std::move(defined), name, where(state), script.scope());
}

}  // namespace trocar::lua
