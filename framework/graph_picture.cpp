// SPDX-License-Identifier: Apache-2.0
#include "framework/graph_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "framework/text.hpp"

namespace trocar {
namespace {

/// "m ×3, rad ×3"
std::string short_units(const std::vector<Unit>& units) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < units.size();) {
    std::size_t end = i;
    while (end < units.size() && units[end].symbol == units[i].symbol) ++end;
    const std::string symbol = units[i].symbol.empty() ? "1" : units[i].symbol;
    parts.push_back(end - i == 1 ? symbol : fmt::format("{} ×{}", symbol, end - i));
    i = end;
  }
  return join(parts, ", ");
}

std::string type_text(const Signature& signature) {
  if (signature.unit_text().empty()) return signature.type->name;
  return fmt::format("{} [{}]", signature.type->name, short_units(signature.units));
}

/// Cut where it would make its box wider than the names do.
std::string short_value(const std::string& text) {
  constexpr std::size_t longest = 32;  // [B]
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + "…";
}

using ArrowsFrom = std::vector<std::vector<std::size_t>>;  // by box, index of the arrows

/// Whether arrows lead from one box to another.
bool leads(const GraphPicture& picture, const ArrowsFrom& arrows_from, std::size_t from,
           std::size_t to) {
  std::vector<std::size_t> open = {from};
  std::vector<bool> reached(picture.boxes.size(), false);
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    if (at == to) return true;
    if (reached[at]) continue;
    reached[at] = true;
    for (const std::size_t each : arrows_from[at])
      if (!picture.arrows[each].back) open.push_back(picture.arrows[each].to);
  }
  return false;
}

/// Each loop has an arrow of a later tick or to another thread, or the graph could not run. From a
/// gate goes first: what flows to a device has its natural end there.
void mark_back(GraphPicture& picture) {
  ArrowsFrom arrows_from(picture.boxes.size());
  for (std::size_t i = 0; i < picture.arrows.size(); ++i)
    arrows_from[picture.arrows[i].from].push_back(i);
  for (const bool gates : {true, false})
    for (GraphPicture::Arrow& arrow : picture.arrows) {
      const bool gate = picture.boxes[arrow.from].shape == GraphPicture::Shape::gate;
      if (gate == gates && arrow.line != GraphPicture::Line::same_tick)
        arrow.back = leads(picture, arrows_from, arrow.to, arrow.from);
    }
}

class Painter {
 public:
  Painter(const Graph& graph, const WiredGraph& wired) : graph_(graph), wired_(wired) {}

  GraphPicture paint() {
    for (std::size_t thread = 0; thread < wired_.groups().size(); ++thread)
      for (const ScheduleItem& item : wired_.groups()[thread].schedule()) {
        const NodeId node = *graph_.find(item.component->name());
        threads_[node] = thread;
        add_box(node);
      }
    for (const Graph::Wire& wire : graph_.wires()) add_wire(wire);
    mark_back(picture_);
    return std::move(picture_);
  }

 private:
  /// The innermost cluster that a node of a thread lies in.
  std::optional<std::size_t> cluster_of(NodeId node, std::size_t thread) {
    const std::optional<NodeId> group = graph_.group_of(node);
    if (!group) return cluster_of_thread(thread);
    const auto known = clusters_.find({*group, thread});
    if (known != clusters_.end()) return known->second;
    const std::optional<std::size_t> outer = cluster_of(*group, thread);
    const Graph::Node& described = graph_.node(*group);
    return clusters_[{*group, thread}] =
               add_cluster({.name = described.name,
                            .title = title_of(*group),
                            .type = described.type == nullptr ? "" : described.type->name,
                            .inside = outer});
  }

  /// None where there is only one.
  std::optional<std::size_t> cluster_of_thread(std::size_t thread) {
    if (wired_.groups().size() == 1) return std::nullopt;
    const auto known = thread_clusters_.find(thread);
    if (known != thread_clusters_.end()) return known->second;
    const RateGroup& group = wired_.groups()[thread];
    return thread_clusters_[thread] =
               add_cluster({.name = "thread " + group.name(),
                            .title = group.name(),
                            .type = fmt::format("thread, {:.6g} Hz, priority {}",
                                                1.0 / group.period(), group.priority()),
                            .inside = std::nullopt});
  }

  std::size_t add_cluster(GraphPicture::Cluster cluster) {
    picture_.clusters.push_back(std::move(cluster));
    return picture_.clusters.size() - 1;
  }

  std::string title_of(NodeId node) const {
    const std::optional<NodeId> group = graph_.group_of(node);
    const std::string& name = graph_.node(node).name;
    return group ? name.substr(graph_.node(*group).name.size() + 1) : name;
  }

  void add_box(NodeId id) {
    const Graph::Node& node = graph_.node(id);
    const bool device = dynamic_cast<const Device*>(wired_.component(id)) != nullptr;
    boxes_[id] = picture_.boxes.size();
    const auto inside = cluster_of(id, threads_.at(id));
    picture_.boxes.push_back(
        {.name = node.name,
         .title = title_of(id),
         .type = node.type->name,
         .notes = notes_of(id),
         .shape = device ? GraphPicture::Shape::device : GraphPicture::Shape::component,
         .inside = inside});
  }

  /// What tells this component from others of its type: its own rate, the settings that it cannot
  /// be without, and those that follow another component's.
  std::vector<std::string> notes_of(NodeId id) const {
    const Graph::Node& node = graph_.node(id);
    std::vector<std::string> notes;
    if (node.rate > 0.0)
      notes.push_back(node.phase == 0 ? fmt::format("{:.6g} Hz", node.rate)
                                      : fmt::format("{:.6g} Hz, phase {}", node.rate, node.phase));
    for (const ParameterBase* parameter : wired_.component(id)->parameters()) {
      const Graph::Link* link = graph_.link_to({id, parameter->name()});
      if (link != nullptr && !encloses(link->from.node, id))
        notes.push_back(fmt::format("{} = {}.{}", parameter->name(),
                                    graph_.node(link->from.node).name, link->from.name));
      else if (parameter->required() && node.set_at.contains(parameter->name()))
        notes.push_back(fmt::format("{} = {}", parameter->name(), short_value(parameter->text())));
    }
    return notes;
  }

  bool encloses(NodeId group, NodeId node) const {
    const std::optional<NodeId> next = graph_.group_of(node);
    return next && (*next == group || encloses(group, *next));
  }

  void add_wire(const Graph::Wire& wire) {
    const Component* source = wired_.component(wire.from.node);
    const Component* target = wired_.component(wire.to.node);
    const OutputPort& output = *source->find_output(wire.from.port);
    const InputPort& input = *target->find_input(wire.to.port);
    const std::string from =
        wire.from.path.empty() ? wire.from.port : wire.from.port + "." + wire.from.path;
    const GraphPicture::Label label{
        (from == wire.to.port ? from : fmt::format("{} → {}", from, wire.to.port)) +
            way_of(wire.from.connection),
        type_text(select_field(*output.signature(), wire.from.path).signature)};
    const std::size_t source_box = boxes_.at(wire.from.node);
    const auto* device = dynamic_cast<const Device*>(target);
    const bool gated =
        device != nullptr && (&input == &device->hold_port() || &input == &device->effort_port());
    add_label(source_box, gated ? gate_of(wire.to.node) : boxes_.at(wire.to.node),
              wire.from.connection ? GraphPicture::Line::other_thread : line_of(input), label);
  }

  /// ", latest, stale 5 ms"
  static std::string way_of(const std::optional<Connection>& connection) {
    if (!connection) return "";
    std::string way = std::string(", ") + to_string(connection->kind);
    if (std::isfinite(connection->stale))
      way += fmt::format(", stale {:.6g} ms", 1e3 * connection->stale);
    return way;
  }

  static GraphPicture::Line line_of(const InputPort& input) {
    return input.feedthrough() ? GraphPicture::Line::same_tick : GraphPicture::Line::later_tick;
  }

  /// In no group, since the executor has it and no graph can go round it; in its device's thread.
  std::size_t gate_of(NodeId device) {
    if (const auto known = gates_.find(device); known != gates_.end()) return known->second;
    const std::size_t gate = picture_.boxes.size();
    const std::string& name = graph_.node(device).name;
    const auto inside = cluster_of_thread(threads_.at(device));
    picture_.boxes.push_back({.name = name,
                              .title = "gate",
                              .type = devices() > 1 ? "of " + name : "",
                              .shape = GraphPicture::Shape::gate,
                              .inside = inside});
    add_label(gate, boxes_.at(device), GraphPicture::Line::later_tick, {"GatedEffort", ""});
    return gates_[device] = gate;
  }

  std::size_t devices() const {
    std::size_t count = 0;
    for (const RateGroup& group : wired_.groups()) count += group.devices().size();
    return count;
  }

  void add_label(std::size_t from, std::size_t to, GraphPicture::Line line,
                 GraphPicture::Label label) {
    const auto [known, is_new] =
        arrows_.emplace(std::tuple(from, to, line), picture_.arrows.size());
    if (is_new) picture_.arrows.push_back({.from = from, .to = to, .line = line});
    picture_.arrows[known->second].labels.push_back(std::move(label));
  }

  const Graph& graph_;
  const WiredGraph& wired_;
  GraphPicture picture_;
  /// By box at either end and line, index of the arrows.
  std::map<std::tuple<std::size_t, std::size_t, GraphPicture::Line>, std::size_t> arrows_;
  std::map<NodeId, std::size_t> boxes_;
  std::map<NodeId, std::size_t> gates_;                             // by device
  std::map<std::pair<NodeId, std::size_t>, std::size_t> clusters_;  // by group and thread
  std::map<std::size_t, std::size_t> thread_clusters_;
  std::map<NodeId, std::size_t> threads_;  // by node, index of wired_.groups()
};

}  // namespace

std::vector<GraphPicture::Part> GraphPicture::parts_of(std::optional<std::size_t> cluster) const {
  std::vector<Part> parts;
  std::vector<bool> seen(clusters.size(), false);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::optional<std::size_t> at = boxes[i].inside, below;
    while (at != cluster && at) {
      below = at;
      at = clusters[*at].inside;
    }
    if (at != cluster || (below && seen[*below])) continue;
    if (below) seen[*below] = true;
    parts.push_back(below ? Part{true, *below} : Part{false, i});
  }
  return parts;
}

GraphPicture picture_of(const Graph& graph, const WiredGraph& wired) {
  return Painter(graph, wired).paint();
}

}  // namespace trocar
