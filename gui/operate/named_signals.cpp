// SPDX-License-Identifier: Apache-2.0
#include "gui/operate/named_signals.hpp"

#include <nlohmann/json.hpp>

namespace trocar::gui {
namespace {

using GraphJson = nlohmann::json;

std::string text(const GraphJson& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

bool flag(const GraphJson& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

const GraphJson& list(const GraphJson& object, const char* key) {
  static const GraphJson none = GraphJson::array();
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? *found : none;
}

/// "wall.force" of the output `name`, or "" where the node has none.
std::string output(const GraphJson& node, const char* name) {
  for (const GraphJson& one : list(node, "outputs"))
    if (text(one, "name") == name) return text(node, "name") + "." + name;
  return "";
}

double number(const GraphJson& node, const char* parameter) {
  for (const GraphJson& one : list(node, "parameters"))
    if (text(one, "name") == parameter && !list(one, "si").empty() && one["si"][0].is_number())
      return one["si"][0].get<double>();
  return 0.0;
}

void take_device(const GraphJson& node, NamedSignals& signals) {
  signals.device = text(node, "name");
  signals.device_type = text(node, "type");
  signals.force_cap = number(node, "handle_force_cap");
  signals.moment_cap = number(node, "handle_moment_cap");
  signals.applied = output(node, "effort_applied");
  signals.scale = output(node, "scale");
  signals.report_age = output(node, "report_age");
  signals.dead_man = output(node, "dead_man");
  signals.device_state = output(node, "device_state");
  for (const GraphJson& one : list(node, "outputs")) {
    signals.simulated = signals.simulated || flag(one, "truth");
    if (text(one, "name") == "device_state")
      for (const GraphJson& label : list(one, "labels"))
        if (label.is_string()) signals.device_states.push_back(label);
  }
}

/// Where the sites of a tool are.
void take_sites(const GraphJson& graph, NamedSignals& signals) {
  for (const GraphJson& group : list(graph, "groups")) {
    const auto sites = group.find("sites");
    if (sites == group.end() || !sites->is_object()) continue;
    const auto take = [&](const char* site, std::string& into) {
      const auto found = sites->find(site);
      if (found != sites->end() && into.empty()) into = text(*found, "position");
    };
    take("tip", signals.tip);
    take("handle", signals.handle);
  }
}

void take_wires(const GraphJson& graph, NamedSignals& signals) {
  const std::string statics = signals.wrench.substr(0, signals.wrench.rfind('.'));
  for (const GraphJson& wire : list(graph, "wires")) {
    const std::string to = text(wire, "to");
    if (!signals.device.empty() && to == signals.device + ".hold")
      signals.hold = text(wire, "from");
    if (!statics.empty() && to == statics + ".origin") signals.origin = text(wire, "from");
  }
}

}  // namespace

NamedSignals NamedSignals::of(const GraphJson& graph) {
  NamedSignals signals;
  if (!graph.is_object()) return signals;
  for (const GraphJson& node : list(graph, "nodes")) {
    if (!node.is_object()) continue;
    if (flag(node, "device") && signals.device.empty()) take_device(node, signals);
    if (signals.wrench.empty()) signals.wrench = output(node, "wrench");
    if (text(node, "category") == "fixtures" || text(node, "type") == "LuaFixture")
      if (const std::string force = output(node, "force"); !force.empty())
        signals.fixtures.push_back({text(node, "name"), force, output(node, "depth")});
  }
  take_sites(graph, signals);
  take_wires(graph, signals);
  return signals;
}

}  // namespace trocar::gui
