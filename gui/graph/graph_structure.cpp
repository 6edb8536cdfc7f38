// SPDX-License-Identifier: Apache-2.0
#include "gui/graph/graph_structure.hpp"

#include <algorithm>
#include <set>

#include "gui/graph/graph_reading.hpp"

namespace trocar::gui {
namespace {

double number_at(const GraphJson& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() && found->is_number() ? found->get<double>()
                                                                           : 0.0;
}

void take_groups(const GraphJson& graph, GraphStructure& structure) {
  for (const GraphJson& group : graph_list(graph, "groups"))
    if (const std::string name = graph_text(group, "name"); !name.empty())
      structure.groups.push_back({name, graph_text(group, "type"), {}});
}

std::optional<std::size_t> group_named(const GraphStructure& structure, const std::string& name) {
  for (std::size_t i = 0; i < structure.groups.size(); ++i)
    if (structure.groups[i].name == name) return i;
  return std::nullopt;
}

/// A group is inside another, and none inside itself, whatever is written.
void nest_groups(const GraphJson& graph, GraphStructure& structure) {
  for (const GraphJson& group : graph_list(graph, "groups")) {
    const auto own = group_named(structure, graph_text(group, "name"));
    const auto outer = group_named(structure, graph_text(group, "group"));
    if (!own || !outer) continue;
    bool inside_itself = false;
    for (auto at = outer; at && !inside_itself; at = structure.groups[*at].outer)
      inside_itself = *at == *own;
    if (!inside_itself) structure.groups[*own].outer = outer;
  }
}

void take_ports(const GraphJson& node, const char* list, bool input,
                std::vector<GraphStructure::Port>& ports) {
  for (const GraphJson& port : graph_list(node, list))
    ports.push_back({graph_text(port, "name"),
                     graph_text(port, "type"),
                     graph_text(port, "unit"),
                     graph_text(port, "frame"),
                     graph_text(port, "doc"),
                     input,
                     {}});
}

void take_nodes(const GraphJson& graph, GraphStructure& structure) {
  std::set<std::string> threads;
  for (const GraphJson& node : graph_list(graph, "nodes")) {
    GraphStructure::Node one;
    one.name = graph_text(node, "name");
    if (one.name.empty() || structure.find(one.name)) continue;
    one.type = graph_text(node, "type");
    one.doc = graph_text(node, "doc");
    one.thread = graph_text(node, "thread");
    one.group = group_named(structure, graph_text(node, "group"));
    one.device = graph_flag(node, "device");
    one.rate = number_at(node, "rate");
    if (!(one.rate > 0.0)) one.rate = number_at(graph_entry(graph, "threads", one.thread), "rate");
    take_ports(node, "inputs", true, one.ports);
    take_ports(node, "outputs", false, one.ports);
    threads.insert(one.thread);
    structure.nodes.push_back(std::move(one));
  }
  structure.threads = threads.size();
}

GraphStructure::Port* port_of(GraphStructure::Node& node, const std::string& name, bool input) {
  const auto found = std::find_if(node.ports.begin(), node.ports.end(), [&](const auto& port) {
    return port.input == input && port.name == name;
  });
  return found == node.ports.end() ? nullptr : &*found;
}

void take_wire(const GraphJson& wire, GraphStructure& structure) {
  if (!wire.is_object() || !wire.contains("source") || !wire.contains("target")) return;
  const GraphJson &source = wire["source"], &target = wire["target"];
  const auto from = structure.find(graph_text(source, "node"));
  const auto to = structure.find(graph_text(target, "node"));
  if (!from || !to) return;
  const std::string input = graph_text(target, "input");
  std::string output = graph_text(source, "output");
  if (auto* port = port_of(structure.nodes[*from], output, false))
    port->connected.push_back(graph_text(wire, "to"));
  if (auto* port = port_of(structure.nodes[*to], input, true))
    port->connected.push_back(graph_text(wire, "from"));
  if (const std::string field = graph_text(source, "field"); !field.empty()) output += "." + field;

  const auto connection = wire.find("connection");
  const bool crosses = connection != wire.end() && connection->is_object();
  const auto line = crosses                           ? GraphStructure::Line::other_thread
                    : graph_flag(wire, "feedthrough") ? GraphStructure::Line::same_tick
                                                      : GraphStructure::Line::later_tick;
  auto edge = std::find_if(structure.edges.begin(), structure.edges.end(), [&](const auto& one) {
    return one.from == *from && one.to == *to && one.line == line;
  });
  if (edge == structure.edges.end())
    edge = structure.edges.insert(edge, {.from = *from, .to = *to, .line = line});
  edge->wires << QString::fromStdString(output == input ? output : output + " → " + input);
  edge->inputs.push_back(graph_text(wire, "to"));
  if (crosses) edge->stale = number_at(*connection, "stale");
}

}  // namespace

GraphStructure GraphStructure::of(const GraphJson& graph) {
  GraphStructure structure;
  take_groups(graph, structure);
  nest_groups(graph, structure);
  take_nodes(graph, structure);
  for (const GraphJson& wire : graph_list(graph, "wires")) take_wire(wire, structure);
  return structure;
}

std::optional<std::size_t> GraphStructure::find(const std::string& node) const {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].name == node) return i;
  return std::nullopt;
}

QString GraphStructure::title(std::size_t node) const {
  const Node& one = nodes[node];
  const std::string prefix = one.group ? groups[*one.group].name + "." : "";
  return QString::fromStdString(one.name.starts_with(prefix) ? one.name.substr(prefix.size())
                                                             : one.name);
}

}  // namespace trocar::gui
