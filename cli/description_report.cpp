// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/description.hpp"
#include "cli/text_table.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string with_doc(std::vector<std::string> facts, const std::string& doc) {
  std::string text;
  for (const std::string& fact : facts)
    if (!fact.empty()) text += (text.empty() ? "" : ", ") + fact;
  return doc.empty() ? text : text + '\n' + doc;
}

std::string facts_of(const Description::Port& port) {
  const std::string type = port.type == "any" ? "any number or vector" : port.type;
  return with_doc({type + (port.unit.empty() ? "" : " [" + port.unit + "]") +
                       (port.frame.empty() ? "" : " in " + port.frame),
                   port.labels.empty() ? "" : "one of " + join(port.labels, ", "),
                   port.several ? "any number of sources" : "",
                   port.from_site  ? "wired by at"
                   : port.optional ? "optional"
                                   : "",
                   port.truth ? "known in simulation only" : ""},
                  port.doc);
}

std::string facts_of(const Description::Parameter& parameter) {
  const bool unit_shown = parameter.unit.empty() || !parameter.range.empty();
  std::vector<std::string> quoted_choices;
  for (const std::string& choice : parameter.choices) quoted_choices.push_back('"' + choice + '"');
  const std::string type =
      parameter.choices.empty() ? parameter.type : "one of " + join(quoted_choices, ", ");
  return with_doc({type + (unit_shown ? "" : " [" + parameter.unit + "]"), parameter.range,
                   parameter.initial.empty() ? "required" : "default " + parameter.initial,
                   parameter.live ? "live" : ""},
                  parameter.doc);
}

template <typename Item>
std::string section(const std::string& title, const std::vector<Item>& items) {
  if (items.empty()) return "";
  TextTable table;
  for (const Item& item : items) table.row({item.name, facts_of(item)});
  return '\n' + title + '\n' + table.text();
}

Json json_of(const Description::Port& port, bool input) {
  Json json = {{"name", port.name},
               {"type", port.type},
               {"unit", port.unit},
               {"frame", port.frame},
               {"doc", port.doc}};
  if (!port.labels.empty()) json["labels"] = port.labels;
  if (input) {
    json["optional"] = port.optional;
    json["several"] = port.several;
  } else {
    json["truth"] = port.truth;
  }
  return json;
}

Json json_of(const Description::Parameter& parameter) {
  Json json = {{"name", parameter.name},   {"type", parameter.type}, {"unit", parameter.unit},
               {"range", parameter.range}, {"default", nullptr},     {"doc", parameter.doc},
               {"live", parameter.live}};
  if (!parameter.initial.empty()) json["default"] = parameter.initial;
  if (!parameter.choices.empty()) json["choices"] = parameter.choices;
  return json;
}

}  // namespace

std::string description_text(const Description& d) {
  std::string text = fmt::format("{} ({}{})\n", d.name, d.category, d.group ? ", a group" : "");
  text += wrapped(d.doc, 2) + "\n  " + d.example + '\n';
  if (d.placed)
    text += wrapped("at = a site of a device wires where it is, and puts its force there.", 2);
  text += section("Inputs", d.inputs) + section("Outputs", d.outputs);
  text += section("Parameters", d.parameters);
  if (!d.sites.empty()) text += "\nSites (for at)\n" + wrapped(join(d.sites, ", "), 2);
  if (!d.parts.empty()) {
    TextTable table;
    for (const auto& [name, type] : d.parts) table.row({name, type});
    text += "\nParts\n" + table.text();
  }
  return text;
}

nlohmann::ordered_json description_json(const Description& d) {
  Json json = {{"name", d.name},   {"category", d.category}, {"doc", d.doc},
               {"group", d.group}, {"placed", d.placed},     {"example", d.example}};
  for (const char* list : {"inputs", "outputs", "parameters"}) json[list] = Json::array();
  for (const auto& port : d.inputs) json["inputs"].push_back(json_of(port, true));
  for (const auto& port : d.outputs) json["outputs"].push_back(json_of(port, false));
  for (const auto& parameter : d.parameters) json["parameters"].push_back(json_of(parameter));
  if (d.group) {
    json["sites"] = d.sites;
    json["parts"] = d.parts;
  }
  return json;
}

}  // namespace trocar::cli
