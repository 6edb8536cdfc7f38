// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "framework/text.hpp"
#include "framework/wiring.hpp"

namespace trocar {

/// Kahn's algorithm. Devices come first, since they report the position of this tick; where the
/// wiring leaves a choice, the order of declaration decides.
void Wiring::order() {
  std::vector<std::size_t> waits_for(graph_.size(), 0);
  std::vector<std::vector<NodeId>> followers(graph_.size());
  for (const ResolvedWire& wire : wires_) {
    if (!wire.to->feedthrough()) continue;
    ++waits_for[wire.to_node];
    followers[wire.from_node].push_back(wire.to_node);
  }

  const auto rank = [&](NodeId id) {
    const bool device = dynamic_cast<const Device*>(result_->components_[id].get()) != nullptr;
    return std::pair(device ? 0 : 1, id);
  };
  std::set<std::pair<int, NodeId>> ready;
  for (NodeId id = 0; id < graph_.size(); ++id) {
    if (!result_->components_[id]) continue;
    if (waits_for[id] == 0) ready.insert(rank(id));
  }
  while (!ready.empty()) {
    const NodeId id = ready.begin()->second;
    ready.erase(ready.begin());
    order_.push_back(id);
    if (auto* device = dynamic_cast<Device*>(result_->components_[id].get()))
      result_->devices_.push_back(device);
    for (const NodeId follower : followers[id])
      if (--waits_for[follower] == 0) ready.insert(rank(follower));
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
      return wire.to_node == at && wire.to->feedthrough() && is_waiting(wire.from_node);
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
