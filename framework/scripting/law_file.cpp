// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/law_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/scripting/entry_lines.hpp"
#include "framework/scripting/law_port_text.hpp"
#include "framework/scripting/loop_definition.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

const std::vector<std::string> sections = {"parameters", "inputs", "outputs", "state", "step"};
const std::vector<std::string> own_parameters = {"memory", "instructions", "deadline", "strict"};

const char* kind_name(LawKind kind) {
  return kind == LawKind::fixture ? "fixture" : "component";
}

LawPort vector_port(const char* name, const char* unit, const char* doc) {
  return {.name = name, .type = &type_info<Vector3>(), .unit = unit, .frame = "device", .doc = doc};
}

/// Reads the definition at the top of a state's stack into `file`.
class LawReader {
 public:
  LawReader(lua_State* state, LawFile& file, Findings& findings)
      : state_(state), file_(file), findings_(findings) {}

  void read() {
    for (const Key& key : ordered_keys(state_, -1))
      if (key.number > 0)
        finding("step", "",
                fmt::format("entry [{}] of trocar.{} has no name: known are {}", key.number,
                            kind_name(file_.kind), join(sections, ", ")));
      else if (std::find(sections.begin(), sections.end(), key.text) == sections.end())
        finding(key.text, "",
                fmt::format("trocar.{} has no \"{}\"{}", kind_name(file_.kind), key.text,
                            suggestion(key.text, sections)));
    each("parameters", [&](const std::string& name) { read_parameter(name); });
    if (file_.kind == LawKind::fixture) {
      file_.inputs.push_back(vector_port("position", "m", "of the point that it is placed at"));
      file_.inputs.push_back(vector_port("velocity", "m/s", "of the point that it is placed at"));
      file_.outputs.push_back(vector_port("force", "N", "on the tool"));
    }
    each("inputs", [&](const std::string& name) { read_port("inputs", name, file_.inputs); });
    each("outputs", [&](const std::string& name) { read_port("outputs", name, file_.outputs); });
    if (file_.kind == LawKind::component && file_.outputs.empty())
      finding("outputs", "", "a component needs outputs, e.g. outputs = { depth = \"m\" }");
    read_state();
    read_step();
  }

 private:
  void finding(std::string_view section, std::string_view name, std::string message) {
    findings_.add({file_.path, file_.line_of(section, name)}, std::move(message));
  }

  template <typename Read>
  void each(const char* section, const Read& read_entry) {
    const int type = lua_getfield(state_, -1, section);
    if (type == LUA_TTABLE) {
      const int table = lua_gettop(state_);
      for (const Key& key : ordered_keys(state_, table)) {
        push_value(state_, table, key);
        if (key.number > 0 || !is_name(key.text))
          finding(
              section, "",
              fmt::format("{}: {} is no name: {} = {{ name = … }}", section,
                          key.number > 0 ? fmt::format("[{}]", key.number) : "\"" + key.text + "\"",
                          section));
        else
          read_entry(key.text);
        lua_settop(state_, table);
      }
    } else if (type != LUA_TNIL) {
      finding(section, "",
              fmt::format("{} = {}: needs a table, {} = {{ … }}", section,
                          to_literal(state_, -1).text(), section));
    }
    lua_pop(state_, 1);
  }

  void read_parameter(const std::string& name) {
    if (std::find(own_parameters.begin(), own_parameters.end(), name) != own_parameters.end())
      return finding("parameters", name,
                     fmt::format("\"{}\" is a parameter that every law has: give this one another "
                                 "name",
                                 name));
    if (!lua_istable(state_, -1))
      return finding(
          "parameters", name,
          fmt::format("parameter {} = {}: needs braces, {} = {{ {} }}", name,
                      to_literal(state_, -1).text(), name, to_literal(state_, -1).text()));
    static const std::vector<std::string> known = {"range", "doc"};
    for (const Key& key : ordered_keys(state_, -1))
      if (key.number == 0 && std::find(known.begin(), known.end(), key.text) == known.end())
        return finding("parameters", name,
                       fmt::format("parameter {} has no \"{}\"{}", name, key.text,
                                   suggestion(key.text, known)));
    DeclaredParameter parameter = read_declared_parameter(state_, name);
    if (parameter.initial.as<std::monostate>() != nullptr)
      return finding(
          "parameters", name,
          fmt::format("parameter {} needs a value at first: {} = {{ \"1 N/mm\" }}", name, name));
    if (parameter.doc.empty()) parameter.doc = "declared in " + file_.name;
    try {
      ParameterSet owner;
      DeclaredParameters().declare(owner, parameter, true);
    } catch (const std::invalid_argument& error) {
      return finding("parameters", name, fmt::format("parameter {}: {}", name, error.what()));
    }
    file_.parameters.push_back(std::move(parameter));
  }

  void read_port(const char* section, const std::string& name, std::vector<LawPort>& ports) {
    const auto same = [&](const LawPort& port) { return port.name == name; };
    if (std::any_of(ports.begin(), ports.end(), same))
      return finding(section, name,
                     fmt::format("a fixture has \"{}\" already: leave it out", name));
    try {
      LawPort port = read_law_port(name, to_literal(state_, -1));
      if (port.doc.empty()) port.doc = "declared in " + file_.name;
      ports.push_back(std::move(port));
    } catch (const std::invalid_argument& error) {
      finding(section, name, fmt::format("{}.{}: {}", section, name, error.what()));
    }
  }

  void read_state() {
    const int type = lua_getfield(state_, -1, "state");
    if (type != LUA_TNIL && type != LUA_TTABLE)
      finding("state", "",
              fmt::format("state = {}: needs a table, state = {{ torn = false }}",
                          to_literal(state_, -1).text()));
    lua_pop(state_, 1);
  }

  void read_step() {
    if (lua_getfield(state_, -1, "step") == LUA_TFUNCTION) {
      lua_Debug function;
      lua_getinfo(state_, ">S", &function);
      file_.step_line = function.linedefined;
      return;
    }
    lua_pop(state_, 1);
    finding("step", "",
            fmt::format(
                "trocar.{} needs step = function({}) … end", kind_name(file_.kind),
                file_.kind == LawKind::fixture ? "p, at, out, state" : "p, inputs, out, state"));
  }

  lua_State* state_;
  LawFile& file_;
  Findings& findings_;
};

}  // namespace

PortOptions LawPort::options() const {
  return {.unit = unit,
          .frame = frame,
          .doc = doc,
          .axes = axes,
          .optional = optional,
          .labels = labels};
}

int LawPort::axes_of() const {
  return type->per_axis == 1 ? static_cast<int>(split(unit, ',').size()) : axes;
}

int LawFile::line_of(std::string_view section, std::string_view entry) const {
  const std::string names[] = {std::string(section), std::string(entry)};
  return line_of_entry(text, std::span(names).first(entry.empty() ? 1 : 2));
}

std::shared_ptr<const LawFile> read_law(LawKind kind, const std::string& name,
                                        const std::string& path, std::string text,
                                        Findings& findings) {
  auto file = std::make_shared<LawFile>();
  file->kind = kind;
  file->name = name;
  file->path = path;
  file->text = std::move(text);
  LoopState state({}, file->name, 1);
  Findings found;
  if (!load_definition(state, file->kind, file->text))
    add_loop_error(file->name, file->path, state.error(), found);
  else
    LawReader(state.lua(), *file, found).read();
  for (const Finding& each : found.all()) findings.add(each.where, each.message);
  return found.empty() ? file : nullptr;
}

}  // namespace trocar::lua
