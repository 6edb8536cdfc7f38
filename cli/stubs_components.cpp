// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "cli/stubs.hpp"
#include "framework/text.hpp"
#include "framework/types.hpp"

namespace trocar::cli {
namespace {

/// A field's name as a class declares it.
std::string key(const std::string& name) {
  return is_name(name) ? name : fmt::format("[\"{}\"]", name);
}

/// A comment of one line: what an editor shows of the field or function below.
std::string comment(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return "---" + text + "\n";
}

std::string output_class(const Description::Port& port) {
  return "trocar.Output." + port.type;
}

std::string port_doc(const Description::Port& port) {
  std::string text = port.type;
  if (!port.unit.empty()) text += fmt::format(" [{}]", port.unit);
  if (!port.frame.empty()) text += " in " + port.frame;
  if (port.optional) text += ", optional";
  if (port.several) text += ", any number of sources";
  if (port.from_site) text += ", wired by at";
  if (port.truth) text += ", known to a simulation alone";
  if (!port.labels.empty()) text += ", one of " + join(port.labels, ", ");
  return text + ": " + port.doc;
}

std::string parameter_doc(const Description::Parameter& parameter) {
  std::vector<std::string> facts;
  if (!parameter.range.empty())
    facts.push_back(parameter.range);
  else if (!parameter.unit.empty())
    facts.push_back("[" + parameter.unit + "]");
  facts.push_back(parameter.initial.empty() ? "required" : "default " + parameter.initial);
  if (parameter.live) facts.emplace_back("live");
  return fmt::format("{} ({})", parameter.doc, join(facts, ", "));
}

/// What a script may write for a parameter.
std::string value_class(const Description::Parameter& parameter) {
  if (!parameter.choices.empty()) {
    std::vector<std::string> choices;
    for (const std::string& choice : parameter.choices) choices.push_back("\"" + choice + "\"");
    return join(choices, "|") + "|trocar.Parameter";
  }
  if (parameter.type == "any value") return "any";
  if (parameter.type == "string") return "string|trocar.Parameter";
  if (parameter.type == "true or false") return "boolean|trocar.Parameter";
  if (parameter.type == "whole number") return "integer|trocar.Parameter";
  if (parameter.type == "rotation") return "trocar.Rotation|trocar.Parameter";
  if (parameter.type == "three numbers" || parameter.type == "a number for each axis")
    return "trocar.Quantity[]|trocar.Parameter";
  return "trocar.Quantity|trocar.Parameter";
}

/// Writes a class; a name that came before stays what it was.
class ClassText {
 public:
  explicit ClassText(const std::string& head) : text_("---@class " + head + "\n") {}
  void add(const std::string& name, bool optional, const std::string& type,
           const std::string& doc) {
    if (!known_.insert(name).second) return;
    if (!doc.empty()) text_ += comment(doc);
    text_ += fmt::format("---@field {}{} {}\n", key(name), optional ? "?" : "", type);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::set<std::string> known_;
};

void add_settings(const Description& description, const std::string& prefix, ClassText& settings) {
  for (const Description::Parameter& parameter : description.parameters)
    settings.add(prefix + parameter.name, !prefix.empty() || !parameter.initial.empty(),
                 value_class(parameter), parameter_doc(parameter));
  for (const Description::Port& input : description.inputs)
    settings.add(prefix + input.name, !prefix.empty() || input.optional || input.from_site,
                 input.several ? "trocar.Source|trocar.Source[]" : "trocar.Source",
                 port_doc(input));
}

std::string settings_class(const Description& description, const Registry& registry) {
  ClassText settings("trocar." + description.name + ".Settings");
  add_settings(description, "", settings);
  settings.add("name", true, "string", "What it is called in signals and logs");
  if (!description.group) {
    settings.add("rate", true, "trocar.Quantity",
                 "An integer fraction of its thread's rate, e.g. \"100 Hz\"");
    settings.add("phase", true, "integer", "By how many ticks of its thread it steps later");
  }
  settings.add("thread", true, "trocar.Thread", "In which it runs");
  if (description.placed)
    settings.add("at", true, "trocar.Site", "A site, e.g. laparoscope.tip: wires what is there");
  for (const auto& [part, type] : description.parts)
    if (registry.find(type) != nullptr)
      add_settings(describe(registry, type), part + ".", settings);
  return settings.text();
}

/// What the constructor returns; what comes first is what a script gets where names are alike. An
/// output with a dot in its name is reached through a table of those that begin alike.
std::string instance_class(const Description& description) {
  const std::string own = "trocar." + description.name;
  ClassText instance(own);
  std::map<std::string, ClassText> tables;
  for (const std::string& site : description.sites)
    instance.add(site, false, "trocar.Site", "A site, for at");
  for (const Description::Port& output : description.outputs) {
    const std::size_t dot = output.name.find('.');
    const std::string table = output.name.substr(0, dot);
    if (dot == std::string::npos) {
      instance.add(output.name, false, output_class(output), port_doc(output));
      continue;
    }
    instance.add(table, false, own + "." + table, "Outputs");
    tables.try_emplace(table, own + "." + table)
        .first->second.add(output.name.substr(dot + 1), false, output_class(output),
                           port_doc(output));
  }
  for (const auto& [part, type] : description.parts)
    instance.add(part, false, type == "group" ? "table" : "trocar." + type, "A part, " + type);
  for (const Description::Parameter& parameter : description.parameters)
    if (parameter.name != description.definition)
      instance.add(parameter.name, false, "trocar.Parameter", parameter_doc(parameter));
  for (const Description::Port& input : description.inputs)
    instance.add(input.name, false, "trocar.Input", port_doc(input));
  std::string text;
  for (const auto& each : tables) text += each.second.text() + "\n";
  const char* const further = "---@field [string] trocar.Output.any\n";
  return text + instance.text() + (description.definition.empty() ? "" : further);
}

std::string output_type(const TypeInfo& type) {
  ClassText text(fmt::format("trocar.Output.{} : trocar.Output", type.name));
  for (const TypeField& field : type.fields)
    text.add(field.name, false, "trocar.Output." + field.type->name, "");
  return text.text();
}

}  // namespace

std::string component_stub(const Description& description, const Registry& registry) {
  return fmt::format(
      "{0}\n{1}\n{2}---\n---    {3}\n"
      "---@param settings trocar.{4}.Settings\n---@return trocar.{4}\n"
      "function trocar.{4}(settings) end\n",
      settings_class(description, registry), instance_class(description), comment(description.doc),
      description.example, description.name);
}

std::string output_types_stub() {
  std::string text;
  for (const TypeInfo* type : port_types()) text += output_type(*type) + "\n";
  return text +
         "---Its type is that of what it is wired to.\n"
         "---@class trocar.Output.any : trocar.Output\n---@field [string] trocar.Output.any\n";
}

std::string components_stub(const Registry& registry) {
  std::string text = std::string(stub_header) + "\n" + output_types_stub();
  ClassText thread("trocar.Thread");
  for (const char* law : {"LuaFixture", "LuaComponent"})
    thread.add(law, false, "fun(settings: trocar.Law.Settings): trocar.Law", "");
  for (const ComponentType& type : registry.types()) {
    text += "\n" + component_stub(describe(registry, type.name), registry);
    thread.add(type.name, false,
               fmt::format("fun(settings: trocar.{0}.Settings): trocar.{0}", type.name), type.doc);
  }
  return text + "\n---What is made through it runs in it.\n" + thread.text();
}

}  // namespace trocar::cli
