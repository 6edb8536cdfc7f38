// SPDX-License-Identifier: Apache-2.0
#include "framework/graph_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace trocar {
namespace {

using Json = nlohmann::ordered_json;

void add_signature(Json& json, const std::optional<Signature>& signature) {
  json["type"] = signature ? signature->type->name : "any";
  if (signature && signature->type->per_axis > 0) json["axes"] = signature->axes;
  json["unit"] = signature ? signature->unit_text() : "";
  json["frame"] = signature ? signature->frame : "";
}

Json port_json(const Port& port) {
  Json json = {{"name", port.name()}};
  add_signature(json, port.signature());
  json["doc"] = port.doc();
  if (!port.labels().empty()) json["labels"] = port.labels();
  return json;
}

class Writer {
 public:
  Writer(const Graph& graph, const WiredGraph* wired) : graph_(graph), wired_(wired) {}

  Json all() const {
    Json json = {{"threads", threads()},
                 {"nodes", Json::array()},
                 {"wires", Json::array()},
                 {"groups", Json::array()}};
    for (NodeId id = 0; id < graph_.size(); ++id)
      if (graph_.node(id).is_group())
        json["groups"].push_back(group(id));
      else
        json["nodes"].push_back(node(id));
    for (const Graph::Wire& each : graph_.wires()) json["wires"].push_back(wire(each));
    return json;
  }

 private:
  const Component* component(NodeId id) const {
    const Component* wired = wired_ == nullptr ? nullptr : wired_->component(id);
    return wired != nullptr ? wired : graph_.node(id).component.get();
  }
  std::string name(const InputRef& input) const {
    return graph_.node(input.node).name + "." + input.port;
  }
  std::string name(const OutputRef& output) const {
    const std::string port = graph_.node(output.node).name + "." + output.port;
    return output.path.empty() ? port : port + "." + output.path;
  }

  /// What components and groups have in common.
  Json described(NodeId id) const {
    const Graph::Node& node = graph_.node(id);
    const std::optional<NodeId> outer = graph_.group_of(id);
    return {{"name", node.name},
            {"type", node.type == nullptr ? "group" : node.type->name},
            {"category", node.type == nullptr ? "" : node.type->category},
            {"doc", node.type == nullptr ? "" : node.type->doc},
            {"group", outer ? Json(graph_.node(*outer).name) : Json()}};
  }

  Json threads() const {
    Json list = Json::array();
    for (const Graph::Thread& thread : graph_.threads())
      list.push_back({{"name", thread.name},
                      {"rate", thread.rate > 0.0 ? Json(thread.rate) : Json()},
                      {"phase", thread.phase},
                      {"priority", thread.priority},
                      {"processor", thread.processor ? Json(*thread.processor) : Json()}});
    return list;
  }

  static Json connection_json(const std::optional<Connection>& connection) {
    if (!connection) return nullptr;
    Json json = {{"kind", to_string(connection->kind)},
                 {"stale", std::isfinite(connection->stale) ? Json(connection->stale) : Json()}};
    if (connection->kind == Connection::Kind::queue) json["size"] = connection->size;
    return json;
  }

  Json node(NodeId id) const {
    const Graph::Node& node = graph_.node(id);
    const Component& own = *component(id);
    Json json = described(id);
    json["thread"] = graph_.threads()[node.thread].name;
    json["device"] = dynamic_cast<const Device*>(&own) != nullptr;
    json["rate"] = node.rate > 0.0 ? Json(node.rate) : Json();
    json["phase"] = node.phase;
    json["parameters"] = parameters(id, own);
    json["inputs"] = json["outputs"] = Json::array();
    for (const InputPort* input : own.inputs()) {
      json["inputs"].push_back(port_json(*input));
      json["inputs"].back().update({{"optional", input->optional()},
                                    {"several", input->variadic()},
                                    {"feedthrough", input->feedthrough()}});
    }
    for (const OutputPort* output : own.outputs()) {
      json["outputs"].push_back(port_json(*output));
      json["outputs"].back()["truth"] = output->truth();
    }
    return json;
  }

  Json parameters(NodeId id, const ParameterSet& settings) const {
    Json list = Json::array();
    for (ParameterBase* parameter : settings.parameters()) {
      Json json = {
          {"name", parameter->name()},
          {"type", parameter->type_name()},
          {"value", parameter->assigned() || graph_.node(id).set_at.contains(parameter->name())
                        ? Json(parameter->text())
                        : Json()},
          {"unit", parameter->unit().symbol},
          {"range", parameter->range_text()},
          {"doc", parameter->doc()},
          {"live", parameter->live()}};
      if (const std::span<double> numbers = parameter->numbers(); !numbers.empty())
        json["si"] = std::vector<double>(numbers.begin(), numbers.end());
      if (!parameter->choices().empty()) json["choices"] = parameter->choices();
      if (const Graph::Link* link = graph_.link_to({id, parameter->name()}))
        json["follows"] = graph_.node(link->from.node).name + "." + link->from.name;
      list.push_back(std::move(json));
    }
    return list;
  }

  Json wire(const Graph::Wire& wire) const {
    Json json = {{"from", name(wire.from)},
                 {"to", name(wire.to)},
                 {"source",
                  {{"node", graph_.node(wire.from.node).name},
                   {"output", wire.from.port},
                   {"field", wire.from.path}}},
                 {"target", {{"node", graph_.node(wire.to.node).name}, {"input", wire.to.port}}}};
    const Component* source = component(wire.from.node);
    const Component* target = component(wire.to.node);
    const OutputPort* output = source ? source->find_output(wire.from.port) : nullptr;
    const InputPort* input = target ? target->find_input(wire.to.port) : nullptr;
    add_signature(json, output == nullptr ? std::nullopt : field(*output, wire.from.path));
    json["feedthrough"] = input == nullptr || input->feedthrough();
    json["connection"] = connection_json(wire.from.connection);
    return json;
  }

  static std::optional<Signature> field(const OutputPort& output, const std::string& path) {
    try {
      if (output.signature()) return select_field(*output.signature(), path).signature;
    } catch (const std::invalid_argument&) {  // a mistake of the script, reported elsewhere
    }
    return std::nullopt;
  }

  Json group(NodeId id) const {
    const Exports& exports = graph_.node(id).exports;
    Json json = described(id);
    json["parameters"] = parameters(id, graph_.node(id).settings());
    for (const char* part : {"inputs", "outputs", "sites", "parts"}) json[part] = Json::object();
    for (const auto& [own, input] : exports.inputs) json["inputs"][own] = name(input);
    for (const auto& [own, output] : exports.outputs) json["outputs"][own] = name(output);
    for (const auto& [own, site] : exports.sites) json["sites"][own] = site_json(site);
    for (const auto& [own, part] : exports.parts) json["parts"][own] = graph_.node(part).name;
    return json;
  }

  Json site_json(const Site& site) const {
    Json json = {{"position", name(site.position)}, {"velocity", name(site.velocity)}};
    if (site.force) json["force"] = name(*site.force);
    if (site.moment) json["moment"] = name(*site.moment);
    if (site.load) json["load"] = name(*site.load);
    return json;
  }

  const Graph& graph_;
  const WiredGraph* wired_;
};

}  // namespace

std::string graph_json(const Graph& graph, const WiredGraph* wired) {
  return Writer(graph, wired).all().dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace trocar
