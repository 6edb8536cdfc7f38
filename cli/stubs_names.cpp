// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cli/stubs.hpp"
#include "framework/recording/row_layout.hpp"
#include "framework/scripting/script.hpp"
#include "framework/wired_graph.hpp"

namespace trocar::cli {
namespace {

using Known = std::map<std::string, ScriptNames::Name>;

void add(Known& known, const std::string& name, std::string doc, bool live = false) {
  std::replace(doc.begin(), doc.end(), '\n', ' ');
  known.insert({name, {name, std::move(doc), live}});
}

void add_signals(Session& session, Known& known) {
  WiringOptions wiring = session.first_wiring();
  wiring.virtual_time = true;
  const auto wired = wire(session.graph(), wiring);
  for (const RowLayout& layout : layouts_of(*wired)) {
    for (const RowPort& port : layout.ports()) {
      const std::string unit = port.signature.unit_text();
      add(known, port.name,
          fmt::format("{}{}: {}", port.signature.type->name,
                      unit.empty() ? "" : fmt::format(" [{}]", unit), port.doc));
    }
    for (const RowSignal& signal : layout.signals())
      add(known, signal.name,
          signal.unit.symbol.empty() ? "a number" : fmt::format("[{}]", signal.unit.symbol));
  }
}

void add_parameters(const Graph& graph, Known& known) {
  for (NodeId id = 0; id < graph.size(); ++id)
    for (const ParameterBase* parameter : graph.node(id).settings().parameters()) {
      const std::string range = parameter->range_text();
      add(known, graph.node(id).name + "." + parameter->name(),
          fmt::format("{} ({}{}{})", parameter->doc(), range, range.empty() ? "" : ", ",
                      parameter->live() ? "live" : "not live"),
          parameter->live());
    }
}

std::vector<ScriptNames::Name> in_order(const Known& known) {
  std::vector<ScriptNames::Name> names;
  for (const auto& each : known) names.push_back(each.second);
  return names;
}

/// @param type "any?" for a key that may be left out
std::string fields(const std::vector<ScriptNames::Name>& names, const char* type, bool live_only) {
  std::string text;
  for (const ScriptNames::Name& each : names)
    if (each.live || !live_only)
      text += fmt::format("---{}\n---@field [\"{}\"] {}\n", each.doc, each.name, type);
  return text;
}

}  // namespace

ScriptNames names_of(const Registry& registry, const std::vector<std::string>& scripts) {
  Known signals, parameters;
  for (const std::string& script : scripts) {
    Session session(registry, {.check_only = true});
    run_script(session, script);
    add_signals(session, signals);
    add_parameters(session.graph(), parameters);
  }
  return {in_order(signals), in_order(parameters)};
}

std::string names_stub(const ScriptNames& names) {
  std::string text = std::string(stub_header) + "\n---A signal's name, e.g. \"wall.force.z\".\n";
  if (names.signals.empty()) {
    text += "---@alias trocar.SignalName string\n";
  } else {
    text += "---@alias trocar.SignalName\n";
    for (const ScriptNames::Name& each : names.signals)
      text += fmt::format("---| '\"{}\"' # {}\n", each.name, each.doc);
    text += "---| string\n";
  }
  text += "\n---@class trocar.Run\n" + fields(names.signals, "trocar.Signal", false);
  text += "\n---Parameters for a run: [\"wall.stiffness\"] = \"3 N/mm\"\n";
  text += "---@class trocar.Set\n" + fields(names.parameters, "any?", false);
  text +=
      "\n---Live parameters and their time: { at = \"1 s\", [\"wall.stiffness\"] = \"3 N/mm\" }\n";
  return text + "---@class trocar.Edit\n---@field at trocar.Quantity\n" +
         fields(names.parameters, "any?", true);
}

}  // namespace trocar::cli
