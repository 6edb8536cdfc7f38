// SPDX-License-Identifier: Apache-2.0
#include "cli/reference.hpp"

#include <fmt/format.h>

#include "cli/catalogue.hpp"
#include "cli/description.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

/// For a cell of a table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find_first_of("|\n", at)) != std::string::npos; at += 2)
    text.replace(at, 1, text[at] == '|' ? "\\|" : "  ");
  return text;
}

std::string code(const std::string& text) {
  return text.empty() ? "" : "`" + cell(text) + "`";
}

std::string port_facts(const Description::Port& port) {
  std::vector<std::string> facts;
  if (!port.labels.empty()) facts.push_back("one of " + join(port.labels, ", "));
  if (port.from_site) facts.emplace_back("wired by `at`");
  if (port.optional) facts.emplace_back("optional");
  if (port.several) facts.emplace_back("any number of sources");
  if (port.truth) facts.emplace_back("known to a simulation alone");
  return cell(port.doc + (facts.empty() ? "" : " (" + join(facts, ", ") + ")"));
}

std::string ports_text(const char* title, const std::vector<Description::Port>& ports) {
  if (ports.empty()) return "";
  std::string text =
      fmt::format("\n| {} | type | unit | frame | |\n|---|---|---|---|---|\n", title);
  for (const Description::Port& port : ports)
    text += fmt::format("| {} | {} | {} | {} | {} |\n", code(port.name), port.type, cell(port.unit),
                        port.frame, port_facts(port));
  return text;
}

std::string allowed(const Description::Parameter& parameter) {
  if (!parameter.choices.empty()) return "\"" + join(parameter.choices, "\", \"") + "\"";
  if (!parameter.range.empty()) return parameter.range;
  return parameter.unit.empty() ? "" : "in " + parameter.unit;
}

std::string parameters_text(const std::vector<Description::Parameter>& parameters) {
  if (parameters.empty()) return "";
  std::string text = "\n| parameter | is | allowed | default | |\n|---|---|---|---|---|\n";
  for (const Description::Parameter& parameter : parameters)
    text += fmt::format("| {} | {} | {} | {} | {}{} |\n", code(parameter.name), parameter.type,
                        cell(allowed(parameter)),
                        parameter.initial.empty() ? "required" : code(parameter.initial),
                        cell(parameter.doc), parameter.live ? " (live)" : "");
  return text;
}

std::string group_text(const Description& description) {
  if (!description.group) return "";
  std::vector<std::string> parts, sites;
  for (const auto& [part, type] : description.parts)
    parts.push_back(fmt::format("{} ({})", code(part), type));
  for (const std::string& site : description.sites) sites.push_back(code(site));
  std::string text;
  if (!sites.empty()) text += "\nSites: " + join(sites, ", ") + ".\n";
  if (!parts.empty()) text += "\nA group of " + join(parts, ", ") + ".\n";
  return text;
}

std::string component_text(const Description& description) {
  return fmt::format("\n### {}\n\n{}.\n\n```lua\n{}\n```\n", description.name, description.doc,
                     description.example) +
         group_text(description) + ports_text("input", description.inputs) +
         ports_text("output", description.outputs) + parameters_text(description.parameters);
}

}  // namespace

std::string reference_markdown(const Registry& registry) {
  std::string text =
      "# Components\n\n"
      "All that scripts can use, from the components' own declarations. "
      "`trocar list --markdown > docs/components.md` writes this page, and a test compares it; "
      "`trocar describe NAME` prints one of them.\n\n"
      "A parameter that is live can be edited while the graph runs. In a script, values carry "
      "their units: `stiffness = \"0.5 N/mm\"`.\n";
  for (const std::string& category : categories_of(registry)) {
    text += "\n## " + category + "\n";
    for (const ComponentType& type : registry.types())
      if (type.category == category) text += component_text(describe(registry, type.name));
  }
  return text;
}

}  // namespace trocar::cli
