// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "framework/text.hpp"
#include "framework/wiring.hpp"

namespace trocar {

/// Kahn's algorithm. Devices come first, since they report the position of this tick. An input
/// without feedthrough may be read before its producer steps, but comes after it where no loop
/// forbids it, so that its component knows the producer's quality when it is configured. Where
/// that leaves a choice, the order of declaration decides.
void Wiring::order() {
  std::vector<std::size_t> waits_for(graph_.size(), 0);
  std::vector<std::size_t> would_follow(graph_.size(), 0);
  std::vector<std::vector<const ResolvedWire*>> wires_from(graph_.size());
  for (const ResolvedWire& wire : wires_) {
    if (wire.connection) continue;  // what comes from another thread comes from an earlier tick
    ++(wire.to->feedthrough() ? waits_for : would_follow)[wire.to_node];
    wires_from[wire.from_node].push_back(&wire);
  }

  const auto rank = [&](NodeId id) {
    const bool device = dynamic_cast<const Device*>(result_->components_[id].get()) != nullptr;
    return std::pair(device ? 0 : would_follow[id] == 0 ? 1 : 2, id);
  };
  std::set<std::pair<int, NodeId>> ready;  // by rank
  for (NodeId id = 0; id < graph_.size(); ++id)
    if (result_->components_[id] && waits_for[id] == 0) ready.insert(rank(id));
  while (!ready.empty()) {
    const NodeId id = ready.begin()->second;
    ready.erase(ready.begin());
    order_.push_back(id);
    for (const ResolvedWire* wire : wires_from[id]) {
      const NodeId next = wire->to_node;
      if (wire->to->feedthrough()) {
        if (--waits_for[next] == 0) ready.insert(rank(next));
        continue;
      }
      const bool was_ready = ready.erase(rank(next)) > 0;
      --would_follow[next];
      if (was_ready) ready.insert(rank(next));
    }
  }

  std::vector<NodeId> waiting;
  for (NodeId id = 0; id < graph_.size(); ++id)
    if (result_->components_[id] && waits_for[id] > 0) waiting.push_back(id);
  if (!waiting.empty()) report_loop(waiting);
}

/// Walks from one waiting component to one that it waits for until one comes twice.
void Wiring::report_loop(const std::vector<NodeId>& waiting) {
  std::vector<bool> is_waiting(graph_.size(), false), seen(graph_.size(), false);
  for (const NodeId id : waiting) is_waiting[id] = true;
  std::vector<const ResolvedWire*> path;  // backwards
  NodeId at = waiting.front();
  while (!seen[at]) {
    seen[at] = true;
    const auto& wires = wires_of_[at];
    const auto into = std::find_if(wires.begin(), wires.end(), [&](std::size_t w) {
      const ResolvedWire& wire = wires_[w];
      return wire.to_node == at && wire.to->feedthrough() && !wire.connection &&
             is_waiting[wire.from_node];
    });
    if (into == wires.end()) return;
    path.push_back(&wires_[*into]);
    at = path.back()->from_node;
  }
  path.erase(path.begin(), std::find_if(path.begin(), path.end(), [&](const ResolvedWire* wire) {
               return wire->to_node == at;
             }));
  std::vector<std::string> steps;
  for (auto wire = path.rbegin(); wire != path.rend(); ++wire) steps.push_back((*wire)->text());
  findings_.add(
      path.front()->where,
      fmt::format("a loop without a delay: {}; break it with trocar.Delay", join(steps, ", ")));
}

}  // namespace trocar
