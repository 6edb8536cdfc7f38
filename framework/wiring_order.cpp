// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

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
  std::vector<NodeId> ready;
  for (NodeId id = 0; id < graph_.size(); ++id)
    if (result_->components_[id] && waits_for[id] == 0) ready.push_back(id);
  while (!ready.empty()) {
    const auto first = std::min_element(ready.begin(), ready.end(),
                                        [&](NodeId a, NodeId b) { return rank(a) < rank(b); });
    const NodeId id = *first;
    ready.erase(first);
    order_.push_back(id);
    for (const ResolvedWire* wire : wires_from[id]) {
      if (!wire->to->feedthrough())
        --would_follow[wire->to_node];
      else if (--waits_for[wire->to_node] == 0)
        ready.push_back(wire->to_node);
    }
  }

  std::vector<NodeId> waiting;
  for (NodeId id = 0; id < graph_.size(); ++id)
    if (result_->components_[id] && waits_for[id] > 0) waiting.push_back(id);
  if (!waiting.empty()) report_loop(waiting);
}

/// Walks from one waiting component to one that it waits for until one comes twice.
void Wiring::report_loop(const std::vector<NodeId>& waiting) {
  const auto is_waiting = [&](NodeId id) {
    return std::find(waiting.begin(), waiting.end(), id) != waiting.end();
  };
  std::vector<const ResolvedWire*> path;  // backwards
  NodeId at = waiting.front();
  while (true) {
    const auto into = std::find_if(wires_.begin(), wires_.end(), [&](const ResolvedWire& wire) {
      return wire.to_node == at && wire.to->feedthrough() && !wire.connection &&
             is_waiting(wire.from_node);
    });
    if (into == wires_.end()) return;
    const auto seen = std::find_if(path.begin(), path.end(),
                                   [&](const ResolvedWire* wire) { return wire->to_node == at; });
    if (seen != path.end()) {
      path.erase(path.begin(), seen);
      break;
    }
    path.push_back(&*into);
    at = into->from_node;
  }
  std::vector<std::string> steps;
  for (auto wire = path.rbegin(); wire != path.rend(); ++wire) steps.push_back((*wire)->text());
  findings_.add(
      path.front()->where,
      fmt::format("a loop without a delay: {}; break it with trocar.Delay", join(steps, ", ")));
}

}  // namespace trocar
