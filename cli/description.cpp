// SPDX-License-Identifier: Apache-2.0
#include "cli/description.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "cli/output.hpp"
#include "framework/component_definition.hpp"
#include "framework/graph.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

void set_signature(Description::Port& port, const std::optional<Signature>& signature) {
  if (!signature) {
    port.type = "any";
    return;
  }
  port.type = signature->type->name;
  port.frame = signature->frame;
  port.unit = signature->unit_text();
}

Description::Port port_of(const Port& port) {
  Description::Port result{.name = port.name(), .doc = port.doc(), .labels = port.labels()};
  set_signature(result, port.generic() ? std::nullopt : port.signature());
  return result;
}

void add_ports(const Component& component, Description& description) {
  const auto placement = component.placement();
  description.placed = placement.has_value();
  for (const InputPort* input : component.inputs()) {
    Description::Port port = port_of(*input);
    port.optional = input->optional();
    port.several = input->variadic();
    port.from_site = placement && (input == placement->position || input == placement->velocity);
    description.inputs.push_back(std::move(port));
  }
  for (const OutputPort* output : component.outputs()) {
    Description::Port port = port_of(*output);
    port.truth = output->truth();
    description.outputs.push_back(std::move(port));
  }
}

void add_parameters(const ParameterSet& settings, Description& description) {
  for (const ParameterBase* parameter : settings.parameters())
    description.parameters.push_back({parameter->name(), parameter->type_name(),
                                      parameter->unit().symbol, parameter->range_text(),
                                      parameter->required() ? "" : parameter->text(),
                                      parameter->doc(), parameter->choices(), parameter->live()});
}

/// It is no parameter, since ports cannot change once they are there; a script sees none of that.
void add_definition(const ComponentDefinition& definition, Description& description) {
  description.definition = definition.entry;
  description.sample = definition.example;
  description.parameters.push_back(
      {.name = definition.entry, .type = "any value", .doc = definition.doc});
}

/// A group says what it offers by building itself into a graph of its own.
void add_group(const Registry& registry, Description& description) {
  Graph graph(registry);
  const auto id = graph.add(description.name, "", {});
  if (!id) return;
  add_parameters(graph.node(*id).settings(), description);
  graph.build_group(*id);
  const Exports& exports = graph.node(*id).exports;
  for (const auto& [name, input] : exports.inputs) {
    const Component* owner = graph.node(input.node).component.get();
    const InputPort* port = owner == nullptr ? nullptr : owner->find_input(input.port);
    if (port == nullptr) continue;
    description.inputs.push_back(port_of(*port));
    description.inputs.back().name = name;
    description.inputs.back().optional = true;  // the group's own wiring makes it whole
  }
  for (const auto& [name, output] : exports.outputs) {
    const Component* owner = graph.node(output.node).component.get();
    const OutputPort* port = owner == nullptr ? nullptr : owner->find_output(output.port);
    if (port == nullptr) continue;
    Description::Port shown = port_of(*port);
    shown.name = name;
    shown.truth = port->truth();
    if (port->signature() && !output.path.empty())
      set_signature(shown, select_field(*port->signature(), output.path).signature);
    description.outputs.push_back(std::move(shown));
  }
  for (const auto& [name, site] : exports.sites) description.sites.push_back(name);
  for (const auto& [name, part] : exports.parts)
    description.parts[name] = graph.node(part).type ? graph.node(part).type->name : "group";
}

/// Something that the parameter would take.
std::string sample(const Description::Parameter& parameter) {
  if (parameter.type == "number in any unit")
    return "\"" + (parameter.initial.empty() ? "1 N" : parameter.initial) + "\"";
  if (!parameter.initial.empty() && parameter.initial.front() != '{')
    return parameter.unit.empty() ? parameter.initial : "\"" + parameter.initial + "\"";
  const std::string one = parameter.unit.empty() ? "1" : "\"1 " + parameter.unit + "\"";
  if (!parameter.choices.empty()) return "\"" + parameter.choices.front() + "\"";
  if (parameter.type == "string") return "\"…\"";
  if (parameter.type == "true or false") return "true";
  if (parameter.type == "three numbers") return fmt::format("{{{0}, {0}, {0}}}", one);
  if (parameter.type == "rotation") return "{pitch = \"20 deg\"}";
  if (parameter.type == "a number for each axis") return fmt::format("{{{}, …}}", one);
  return one;
}

std::string example_of(const Description& description) {
  std::vector<std::string> settings;
  if (description.placed) settings.emplace_back("at = laparoscope.tip");
  for (const Description::Port& input : description.inputs)
    if (!input.optional && !input.from_site)
      settings.push_back(fmt::format("{0} = other.{0}", input.name));
  for (const Description::Parameter& parameter : description.parameters)
    if (parameter.initial.empty())
      settings.push_back(fmt::format(
          "{} = {}", parameter.name,
          parameter.name == description.definition ? description.sample : sample(parameter)));
  constexpr std::size_t enough = 3;
  for (const Description::Parameter& parameter : description.parameters)
    if (settings.size() < enough && !parameter.initial.empty() && parameter.initial != "\"\"" &&
        parameter.initial.front() != '{')
      settings.push_back(fmt::format("{} = {}", parameter.name, sample(parameter)));
  return fmt::format("local {} = trocar.{} {{ {} }}", snake_case(description.name),
                     description.name, join(settings, ", "));
}

}  // namespace

Description describe(const Registry& registry, std::string_view name) {
  const ComponentType* type = registry.find(name);
  if (type == nullptr)
    throw std::invalid_argument(fmt::format("there is no component {}{}", in_quotes(name),
                                            suggestion(name, registry.names())));
  Description description{
      .name = type->name, .category = type->category, .doc = type->doc, .group = !type->make};
  if (description.group) {
    add_group(registry, description);
  } else {
    if (type->definition) add_definition(*type->definition, description);
    const auto component = type->make();
    add_ports(*component, description);
    add_parameters(*component, description);
  }
  description.example = example_of(description);
  return description;
}

}  // namespace trocar::cli
