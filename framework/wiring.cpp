// SPDX-License-Identifier: Apache-2.0
#include "framework/wiring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "framework/text.hpp"

namespace trocar {
namespace {

/// FNV-1a, so that a component's random numbers depend on its name and not on its neighbours.
std::uint64_t seed_for(std::uint64_t run_seed, std::string_view name) {
  std::uint64_t hash = 14695981039346656037ull ^ run_seed;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return hash;
}

std::vector<std::string> port_names(const auto& ports) {
  std::vector<std::string> names;
  for (const auto* port : ports) names.push_back(port->name());
  return names;
}

}  // namespace

std::string ResolvedWire::text() const {
  return fmt::format("{}.{}{}{} → {}.{}", from->owner_name(), from->name(), path.empty() ? "" : ".",
                     path, to->owner_name(), to->name());
}

Wiring::Wiring(const Graph& graph, const WiringOptions& options)
    : graph_(graph), options_(options), result_(std::make_unique<WiredGraph>()) {
  for (const Finding& finding : graph.findings().all())
    findings_.add(finding.where, finding.message);
}

std::unique_ptr<WiredGraph> Wiring::build() {
  instantiate();
  settle_threads();
  apply_settings();
  follow_links();
  require_parameters();
  resolve_wires();
  resolve_signatures();
  check_wires();
  check_inputs();
  check_rates();
  check_connections();
  check_truth();
  order();
  if (!findings_.empty()) throw BrokenGraph(findings_);
  make_groups();
  connect();
  configure();
  check_limits();
  mark_dependencies();
  if (!findings_.empty()) throw BrokenGraph(findings_);
  return std::move(result_);
}

void Wiring::instantiate() {
  for (NodeId id = 0; id < graph_.size(); ++id) {
    const Graph::Node& node = graph_.node(id);
    std::unique_ptr<Component> component;
    if (!node.is_group()) {
      component = node.type->make();
      component->set_name(node.name);
      for (std::size_t i = 0; i < component->parameters().size(); ++i)
        component->parameters()[i]->copy_from(*node.component->parameters()[i]);
      result_->by_name_.emplace(component->name(), component.get());
    }
    result_->components_.push_back(std::move(component));
  }
}

Wiring::~Wiring() {
  for (auto& [parameter, value] : borrowed_) parameter->restore(value);
}

ParameterBase* Wiring::find_parameter(NodeId node, std::string_view name) const {
  return graph_.node(node).is_group() ? graph_.node(node).group->find_parameter(name)
                                      : result_->components_[node]->find_parameter(name);
}

void Wiring::apply_settings() {
  for (const auto& [key, setting] : options_.set) {
    const std::size_t dot = std::min(key.rfind('.'), key.size());
    const auto node = graph_.find(key.substr(0, dot));
    ParameterBase* parameter =
        node && dot < key.size() ? find_parameter(*node, key.substr(dot + 1)) : nullptr;
    if (parameter == nullptr) {
      const std::vector<std::string> known = graph_.parameter_keys();
      findings_.add(setting.where,
                    fmt::format("nothing is called \"{}\"{}", key,
                                nearest(key, known).empty() ? "" : suggestion(key, known)));
      continue;
    }
    if (graph_.node(*node).is_group()) borrowed_.emplace_back(parameter, parameter->save());
    if (const std::string wrong = parameter->set(setting.value); !wrong.empty())
      findings_.add(setting.where, fmt::format("{} = {}: {}", key, setting.value.text(), wrong));
  }
}

Where Wiring::where_set(NodeId node, const std::string& parameter) const {
  const auto& set_at = graph_.node(node).set_at;
  const auto found = set_at.find(parameter);
  return found == set_at.end() ? where_of(node) : found->second;
}

/// Each after the link that feeds its source, in whatever order they were declared.
std::vector<const Graph::Link*> Wiring::ordered_links() const {
  std::map<std::pair<NodeId, std::string_view>, std::vector<const Graph::Link*>> into;
  for (const Graph::Link& link : graph_.links())
    into[{link.to.node, link.to.name}].push_back(&link);
  std::vector<const Graph::Link*> ordered;
  std::set<const Graph::Link*> seen;
  const auto visit = [&](const auto& self, const Graph::Link& link) -> void {
    if (!seen.insert(&link).second) return;
    if (const auto found = into.find({link.from.node, link.from.name}); found != into.end())
      for (const Graph::Link* before : found->second) self(self, *before);
    ordered.push_back(&link);
  };
  for (const Graph::Link& link : graph_.links()) visit(visit, link);
  return ordered;
}

void Wiring::follow_links() {
  for (const Graph::Link* each : ordered_links()) {
    const Graph::Link& link = *each;
    const Graph::Node& source = graph_.node(link.from.node);
    const Graph::Node& target = graph_.node(link.to.node);
    if (options_.set.contains(target.name + "." + link.to.name)) continue;
    const ParameterBase* from = find_parameter(link.from.node, link.from.name);
    ParameterBase* to = find_parameter(link.to.node, link.to.name);
    if (from == nullptr || to == nullptr) {
      findings_.add(link.where,
                    fmt::format("cannot give {}.{} to {}.{}: there is no such parameter",
                                source.name, link.from.name, target.name, link.to.name));
      continue;
    }
    std::string wrong;
    if (const auto* any = dynamic_cast<const Parameter<Literal>*>(from))
      wrong = to->set(**any);
    else if (typeid(*from) == typeid(*to) && from->unit().dimension == to->unit().dimension)
      to->copy_from(*from);
    else if (dynamic_cast<const Parameter<double>*>(from) != nullptr &&
             dynamic_cast<const Parameter<Quantity>*>(to) != nullptr)
      wrong = to->set(literal_from_text(from->text()));
    else
      wrong = fmt::format("a {} [{}] cannot be a {} [{}]", from->type_name(), from->unit().symbol,
                          to->type_name(), to->unit().symbol);
    if (!wrong.empty())
      findings_.add(link.where,
                    fmt::format("{}.{} = {}: {}", target.name, link.to.name, from->text(), wrong));
  }
}

void Wiring::require_parameters() {
  for (NodeId id = 0; id < graph_.size(); ++id) {
    const Graph::Node& node = graph_.node(id);
    for (const ParameterBase* parameter : node.settings().parameters())
      if (!parameter->assigned() && !node.set_at.contains(parameter->name()) &&
          !options_.set.contains(node.name + "." + parameter->name()))
        findings_.add(
            node.where,
            fmt::format("{} needs \"{}\" ({}{})", node.name, parameter->name(), parameter->doc(),
                        parameter->unit().symbol.empty()
                            ? ""
                            : fmt::format(", e.g. \"1 {}\"", parameter->unit().symbol)));
  }
}

void Wiring::resolve_wires() {
  wires_of_.resize(graph_.size());
  for (const Graph::Wire& wire : graph_.wires()) {
    Component* source = result_->components_[wire.from.node].get();
    Component* target = result_->components_[wire.to.node].get();
    OutputPort* from = source == nullptr ? nullptr : source->find_output(wire.from.port);
    InputPort* to = target == nullptr ? nullptr : target->find_input(wire.to.port);
    if (from == nullptr)
      findings_.add(
          wire.where,
          fmt::format("{} has no output \"{}\"{}", graph_.node(wire.from.node).name, wire.from.port,
                      suggestion(wire.from.port, source ? port_names(source->outputs())
                                                        : std::vector<std::string>{})));
    if (to == nullptr)
      findings_.add(
          wire.where,
          fmt::format("{} has no input \"{}\"{}", graph_.node(wire.to.node).name, wire.to.port,
                      suggestion(wire.to.port, target ? port_names(target->inputs())
                                                      : std::vector<std::string>{})));
    if (from == nullptr || to == nullptr) continue;
    wires_into_[to].push_back(wires_.size());
    wires_of_[wire.from.node].push_back(wires_.size());
    wires_of_[wire.to.node].push_back(wires_.size());
    wires_.push_back(
        {wire.from.node, wire.to.node, from, to, wire.from.path, wire.from.connection, wire.where});
  }
}

const std::vector<std::size_t>& Wiring::wires_into(const InputPort& input) const {
  static const std::vector<std::size_t> none;
  const auto found = wires_into_.find(&input);
  return found == wires_into_.end() ? none : found->second;
}

void Wiring::check_inputs() {
  for (NodeId id = 0; id < graph_.size(); ++id) {
    if (!result_->components_[id]) continue;
    for (const InputPort* input : result_->components_[id]->inputs()) {
      const std::vector<std::size_t>& drivers = wires_into(*input);
      const bool excused = graph_.node(id).set_at.contains(input->name());  // a finding elsewhere
      if (drivers.empty() && !input->optional() && !input->variadic() && !excused)
        findings_.add(where_of(id), fmt::format("{}.{} is not connected: {}", input->owner_name(),
                                                input->name(), input->doc()));
      for (std::size_t i = 1; i < drivers.size() && !input->variadic(); ++i)
        findings_.add(
            wires_[drivers[i]].where,
            fmt::format("{}.{} is driven already (at {}): add the two with + first",
                        input->owner_name(), input->name(), wires_[drivers[0]].where.text()));
    }
  }
}

void Wiring::check_rates() {
  if (!(options_.rate >= 1.0) || !(options_.rate <= 1e5))
    findings_.add({}, fmt::format("a rate of {} Hz: 1 Hz to 100 kHz is possible", options_.rate));
  for (NodeId id = 0; id < graph_.size(); ++id) {
    const Graph::Node& node = graph_.node(id);
    if (node.rate == 0.0) continue;
    const double thread_rate = this->thread_rate(id);
    const double ratio = thread_rate / node.rate;
    const double divider = std::round(ratio);
    if (!(node.rate > 0.0) || !(ratio >= 1.0 - 1e-9))
      findings_.add(where_set(id, "rate"),
                    fmt::format("{}: {} Hz is not within 0 to the thread's {} Hz", node.name,
                                node.rate, thread_rate));
    else if (std::abs(ratio - divider) > 1e-9 * ratio)
      findings_.add(
          where_set(id, "rate"),
          fmt::format("{}: {:.6g} Hz does not divide the thread's {:.6g} Hz; near are {:.6g} and "
                      "{:.6g} Hz",
                      node.name, node.rate, thread_rate, thread_rate / std::floor(ratio),
                      thread_rate / std::ceil(ratio)));
    else if (node.phase < 0 || static_cast<double>(node.phase) >= divider)
      findings_.add(where_set(id, "rate"), fmt::format("{}: phase {} is not within 0–{}", node.name,
                                                       node.phase, divider - 1.0));
  }
}

/// Thread after thread: what comes from a later one counts as exact.
void Wiring::configure() {
  // What is fed by a component that refused would be configured on nothing.
  std::vector<bool> unsound(graph_.size(), false);
  std::vector<std::vector<NodeId>> feeds(graph_.size());
  for (const ResolvedWire& wire : wires_)
    if (wire.to->feedthrough()) feeds[wire.from_node].push_back(wire.to_node);
  for (const NodeId id : order_) {
    if (unsound[id]) {
      for (const NodeId next : feeds[id]) unsound[next] = true;
      continue;
    }
    Component& component = *result_->components_[id];
    const RateGroup& group = group_of(id);
    const double divider = static_cast<double>(group.schedule()[item_index_[id]].divider);
    try {
      component.configure({.period = group.period() * divider,
                           .seed = seed_for(options_.seed, component.name()),
                           .virtual_time = options_.virtual_time,
                           .reloadable = options_.reloadable});
    } catch (const std::invalid_argument& error) {
      findings_.add(where_of(id), fmt::format("{}: {}", component.name(), error.what()));
      for (const NodeId next : feeds[id]) unsound[next] = true;
    }
  }
}

void Wiring::check_limits() {
  constexpr std::size_t most_devices = 32;  // a bit each in the schedule's dependencies
  for (const RateGroup& group : result_->groups())
    if (group.devices().size() > most_devices)
      findings_.add({}, fmt::format("{} devices in one thread: {} are possible",
                                    group.devices().size(), most_devices));
  if (!findings_.empty()) return;
  for (const RateGroup& group : result_->groups())
    for (const Device* device : group.devices()) {
      const std::vector<std::string> missing = device->limits().missing();
      if (!missing.empty())
        findings_.add(where_of(*graph_.find(device->name())),
                      fmt::format("{}: the device does not declare its limits: {}", device->name(),
                                  join(missing, ", ")));
    }
}

std::unique_ptr<WiredGraph> wire(const Graph& graph, const WiringOptions& options) {
  return Wiring(graph, options).build();
}

Findings check(const Graph& graph, const WiringOptions& options) {
  try {
    wire(graph, options);
    return {};
  } catch (const BrokenGraph& broken) {
    return broken.findings;
  }
}

Component* WiredGraph::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : found->second;
}

std::vector<ParameterBase*> WiredGraph::followers(const Graph& graph,
                                                  const ParameterRef& parameter) const {
  std::vector<ParameterRef> reached = {parameter};
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const Graph::Link& link : graph.links())
      if (link.from.node == reached[i].node && link.from.name == reached[i].name)
        reached.push_back(link.to);
  std::vector<ParameterBase*> result;
  for (const ParameterRef& ref : reached)
    if (components_[ref.node])
      if (ParameterBase* found = components_[ref.node]->find_parameter(ref.name))
        result.push_back(found);
  return result;
}

}  // namespace trocar
