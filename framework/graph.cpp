// SPDX-License-Identifier: Apache-2.0
#include "framework/graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "framework/text.hpp"

namespace trocar {
namespace {

constexpr int most_processors = 1024;  // of CPU_SET

}  // namespace

const ParameterSet& Graph::Node::settings() const {
  return is_group() ? *group : static_cast<const ParameterSet&>(*component);
}

std::optional<NodeId> Graph::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? std::nullopt : std::optional(found->second);
}

ThreadId Graph::add_thread(Thread thread) {
  const std::string key = "thread " + thread.name;
  if (!(thread.rate >= 1.0 && thread.rate <= 1e5))
    findings_.add(thread.where, fmt::format("{}: a rate of {} Hz: 1 Hz to 100 kHz is possible", key,
                                            thread.rate));
  else if (thread.priority < 1 || thread.priority > 98)
    findings_.add(thread.where, fmt::format("{}: priority = {}: 1 to 98 is possible, higher goes "
                                            "first",
                                            key, thread.priority));
  else if (!(thread.phase >= 0.0 && thread.phase < 1.0 / thread.rate))
    findings_.add(thread.where,
                  fmt::format("{}: phase = {} s: needs 0 to less than the period of {} s", key,
                              thread.phase, 1.0 / thread.rate));
  else if (thread.processor && (*thread.processor < 0 || *thread.processor >= most_processors))
    findings_.add(thread.where, fmt::format("{}: processor = {}: needs 0 to {}", key,
                                            *thread.processor, most_processors - 1));
  threads_.push_back(std::move(thread));
  return threads_.size() - 1;
}

std::string Graph::rename_thread(ThreadId thread, std::string_view name) {
  if (!is_name(name))
    return fmt::format(
        "\"{}\" is no name: letters, digits and underscores are, starting with a "
        "letter",
        name);
  for (ThreadId other = 0; other < threads_.size(); ++other)
    if (other != thread && threads_[other].name == name)
      return fmt::format("\"{}\" is the name of another thread already", name);
  threads_[thread].name = name;
  return "";
}

std::optional<NodeId> Graph::group_of(NodeId id) const {
  std::string_view name = nodes_[id].name;
  for (auto dot = name.rfind('.'); dot != std::string_view::npos; dot = name.rfind('.')) {
    name = name.substr(0, dot);
    if (const auto outer = find(name); outer && nodes_[*outer].is_group()) return outer;
  }
  return std::nullopt;
}

const Graph::Link* Graph::link_to(const ParameterRef& parameter) const {
  const auto found = link_into_.find({parameter.node, parameter.name});
  return found == link_into_.end() ? nullptr : &links_[found->second];
}

std::optional<std::string> Graph::free_name(std::string_view type, std::string_view name,
                                            const Where& where, std::string_view scope) {
  if (!name.empty() && !is_name(name)) {
    findings_.add(where, fmt::format("name = \"{}\": needs letters, digits and underscores, "
                                     "starting with a letter",
                                     name));
    return std::nullopt;
  }
  const std::string own = name.empty() ? snake_case(type) : std::string(name);
  const std::string full = scope.empty() ? own : fmt::format("{}.{}", scope, own);
  if (const auto taken = find(full)) {
    findings_.add(where,
                  fmt::format("\"{}\" is the name of the {} at {}: give this one another, "
                              "{} {{ name = \"second_{}\", … }}",
                              full, nodes_[*taken].type ? nodes_[*taken].type->name : "group",
                              nodes_[*taken].where.text(), type, own));
    return std::nullopt;
  }
  return full;
}

std::string Graph::rename(NodeId id, std::string_view name, std::string_view scope) {
  if (!is_name(name))
    return fmt::format(
        "\"{}\" is no name: letters, digits and underscores are, starting with a "
        "letter",
        name);
  std::string full = scope.empty() ? std::string(name) : fmt::format("{}.{}", scope, name);
  if (full == nodes_[id].name) return "";
  if (find(full)) return fmt::format("\"{}\" is the name of something else already", full);
  by_name_.erase(nodes_[id].name);
  give_back(nodes_[id].name);
  by_name_.emplace(full, id);
  nodes_[id].name = std::move(full);
  if (nodes_[id].component) nodes_[id].component->set_name(nodes_[id].name);
  apply_overrides(id);
  return "";
}

std::string Graph::unused_name(const std::string& stem, const std::string& scope) {
  const std::string prefix = scope.empty() ? "" : scope + ".";
  int& number = first_unused_.emplace(prefix + stem, 1).first->second;
  const auto name = [&] { return number == 1 ? stem : fmt::format("{}_{}", stem, number); };
  while (find(prefix + name())) ++number;
  return name();
}

/// The name may be "stem", or "stem_3" of another stem.
void Graph::give_back(const std::string& name) {
  const auto unused = [&](const std::string& stem, int number) {
    const auto known = first_unused_.find(stem);
    if (known != first_unused_.end()) known->second = std::min(known->second, number);
  };
  unused(name, 1);
  const std::size_t end = name.rfind('_');
  int number = 0;
  if (end != std::string::npos &&
      std::from_chars(name.data() + end + 1, name.data() + name.size(), number).ec == std::errc())
    unused(name.substr(0, end), std::max(1, number));
}

std::optional<NodeId> Graph::add(std::string_view type_name, std::string_view name,
                                 const Where& where, std::string_view scope) {
  const ComponentType* type = registry_.find(type_name);
  if (type == nullptr) {
    findings_.add(where, fmt::format("there is no component \"{}\"{}", type_name,
                                     suggestion(type_name, registry_.names())));
    return std::nullopt;
  }
  return add_of_type(*type, name, where, scope);
}

std::optional<NodeId> Graph::add(std::unique_ptr<ComponentType> type, std::string_view name,
                                 const Where& where, std::string_view scope) {
  own_types_.push_back(std::move(type));
  return add_of_type(*own_types_.back(), name, where, scope);
}

std::optional<NodeId> Graph::add_of_type(const ComponentType& type, std::string_view name,
                                         const Where& where, std::string_view scope) {
  auto full = free_name(type.name, name, where, scope);
  if (!full) return std::nullopt;
  Node node{.name = std::move(*full), .type = &type, .where = where, .thread = current_thread_};
  if (type.make) {
    node.component = type.make();
    node.component->set_name(node.name);
  } else {
    node.group = type.make_group();
  }
  by_name_.emplace(node.name, nodes_.size());
  nodes_.push_back(std::move(node));
  apply_overrides(nodes_.size() - 1);
  return nodes_.size() - 1;
}

std::optional<NodeId> Graph::add_group(std::unique_ptr<ParameterSet> parameters,
                                       std::string_view type, std::string_view name,
                                       const Where& where, std::string_view scope) {
  auto full = free_name(type, name, where, scope);
  if (!full) return std::nullopt;
  by_name_.emplace(*full, nodes_.size());
  nodes_.push_back({.name = std::move(*full),
                    .where = where,
                    .group = std::move(parameters),
                    .thread = current_thread_});
  apply_overrides(nodes_.size() - 1);
  return nodes_.size() - 1;
}

void Graph::build_group(NodeId group) {
  GroupScope scope(*this, group);
  static_cast<Group&>(*nodes_[group].group).build(scope);
}

void Graph::apply_overrides(NodeId id) {
  const std::string prefix = nodes_[id].name + ".";
  for (auto each = overrides.lower_bound(prefix);
       each != overrides.end() && each->first.starts_with(prefix); ++each) {
    auto& [key, override] = *each;
    const std::string parameter = key.substr(prefix.size());
    ParameterBase* found = nodes_[id].settings().find_parameter(parameter);
    if (found == nullptr) continue;
    override.used = true;
    if (const std::string wrong = found->set(override.value); !wrong.empty())
      findings_.add(override.where, fmt::format("{} = {}: {}", key, override.value.text(), wrong));
    nodes_[id].set_at[parameter] = override.where;
  }
}

std::vector<std::string> Graph::parameter_keys() const {
  std::vector<std::string> keys;
  for (const Node& node : nodes_)
    for (const std::string& parameter : node.settings().parameter_names())
      keys.push_back(node.name + "." + parameter);
  return keys;
}

void Graph::report_unused_overrides() {
  const std::vector<std::string> known = parameter_keys();
  for (const auto& [key, override] : overrides)
    if (!override.used)
      findings_.add(override.where,
                    fmt::format("nothing is called \"{}\"{}", key,
                                nearest(key, known).empty() ? "" : suggestion(key, known)));
}

void Graph::set(const ParameterRef& parameter, const Literal& value, const Where& where) {
  Node& node = nodes_[parameter.node];
  const std::string key = node.name + "." + parameter.name;
  if (overrides.contains(key)) return;
  ParameterBase* found = node.settings().find_parameter(parameter.name);
  if (found == nullptr) {
    findings_.add(where,
                  fmt::format("{} has no parameter \"{}\"{}", node.name, parameter.name,
                              suggestion(parameter.name, node.settings().parameter_names())));
    return;
  }
  node.set_at[parameter.name] = where;
  if (const std::string wrong = found->set(value); !wrong.empty())
    findings_.add(where, fmt::format("{} = {}: {}", key, value.text(), wrong));
}

void Graph::link(const ParameterRef& from, const ParameterRef& to, const Where& where) {
  const std::string key = nodes_[to.node].name + "." + to.name;
  if (overrides.contains(key)) return;
  link_into_[{to.node, to.name}] = links_.size();
  links_.push_back({from, to, where});
  nodes_[to.node].set_at[to.name] = where;
}

void Graph::connect(const OutputRef& from, const InputRef& to, const Where& where) {
  wires_.push_back({from, to, where});
}

void Graph::place(NodeId id, const Site& site, const Where& where) {
  const Node& node = nodes_[id];
  if (!node.component || !node.component->placement()) {
    findings_.add(where, fmt::format("{}: a {} cannot be placed at a site", node.name,
                                     node.type ? node.type->name : "group"));
    return;
  }
  const Placement placement = *node.component->placement();
  if (placement.position != nullptr)
    connect(site.position, {id, placement.position->name()}, where);
  if (placement.velocity != nullptr)
    connect(site.velocity, {id, placement.velocity->name()}, where);
  const bool load = placement.acts == Placement::Acts::on_tool;
  const auto& force_input = load ? site.load : site.force;
  if (placement.force != nullptr && force_input)
    connect({id, placement.force->name()}, *force_input, where);
  else if (placement.force != nullptr)
    findings_.add(where, fmt::format("{}: this site takes no {}", node.name,
                                     load ? "external load" : "rendered force"));
  if (placement.moment != nullptr && site.moment)
    connect({id, placement.moment->name()}, *site.moment, where);
}

void Graph::set_rate(NodeId id, double rate, std::int64_t phase, const Where& where) {
  nodes_[id].rate = rate;
  nodes_[id].phase = phase;
  nodes_[id].set_at["rate"] = where;
}

NodeId GroupScope::add(std::string_view type, std::string_view name) {
  const Graph::Node& group = graph_.node(group_);
  const auto id = graph_.add(type, name, group.where, group.name);
  if (!id) throw std::logic_error(fmt::format("group {}: cannot add {}", group.name, type));
  graph_.node(group_).exports.parts.emplace(name, *id);
  return *id;
}

void GroupScope::connect(const OutputRef& from, const InputRef& to) {
  graph_.connect(from, to, graph_.node(group_).where);
}

void GroupScope::set(NodeId node, std::string_view parameter, const Literal& value) {
  graph_.set({node, std::string(parameter)}, value, graph_.node(group_).where);
}

void GroupScope::forward(std::string_view parameter, NodeId node, std::string_view part_parameter) {
  graph_.link({group_, std::string(parameter)}, {node, std::string(part_parameter)},
              graph_.node(group_).where);
}

}  // namespace trocar
