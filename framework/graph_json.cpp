// SPDX-License-Identifier: Apache-2.0
#include "framework/graph_json.hpp"

#include <nlohmann/json.hpp>

namespace trocar {

std::string graph_json(const Graph& graph) {
  using Json = nlohmann::ordered_json;
  Json nodes = Json::array();
  for (NodeId id = 0; id < graph.size(); ++id) {
    const Graph::Node& node = graph.node(id);
    Json parameters = Json::object();
    for (const ParameterBase* parameter : node.settings().parameters())
      parameters[parameter->name()] = parameter->text();
    nodes.push_back({{"name", node.name},
                     {"type", node.type == nullptr ? "group" : node.type->name},
                     {"parameters", parameters}});
  }
  Json wires = Json::array();
  for (const Graph::Wire& wire : graph.wires()) {
    std::string from = graph.node(wire.from.node).name + "." + wire.from.port;
    if (!wire.from.path.empty()) from += "." + wire.from.path;
    wires.push_back({{"from", from}, {"to", graph.node(wire.to.node).name + "." + wire.to.port}});
  }
  const Json all = {{"nodes", nodes}, {"wires", wires}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace trocar
