// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "framework/graph.hpp"
#include "framework/rate_group.hpp"

namespace trocar {

struct WiringOptions {
  double rate = 1000.0;       // [Hz] of the threads that say none
  std::uint64_t seed = 1;     // of everything random
  Graph::Overrides set{};     // for this run only; win over the script's values
  bool virtual_time = false;  // no component may look at a clock
  bool reloadable = false;    // laws may be replaced while they run
};

/// A graph whose components exist, are wired, checked, ordered and configured: ready to run once.
class WiredGraph {
 public:
  /// One for each thread that has a component, in the order of declaration; at least one.
  const std::deque<RateGroup>& groups() const { return groups_; }
  const RateGroup& main() const { return groups_.front(); }
  /// By the graph's node; null for a group.
  Component* component(NodeId node) const { return components_[node].get(); }
  Component* find(std::string_view name) const;
  /// The parameters that move when this one is edited: itself and those that follow it.
  std::vector<ParameterBase*> followers(const Graph& graph, const ParameterRef& parameter) const;

 private:
  friend class Wiring;
  std::vector<std::unique_ptr<Component>> components_;
  std::unordered_map<std::string_view, Component*> by_name_;
  std::deque<RateGroup> groups_;
  std::deque<Crossing> crossings_;
};

/// Builds the components of a graph, resolves generic ports, checks everything (types, units,
/// frames, missing inputs, double drivers, loops, rates, threads, limits, what only a simulation
/// knows) and configures in order.
/// @throw BrokenGraph with every finding, the graph's own included.
std::unique_ptr<WiredGraph> wire(const Graph& graph, const WiringOptions& options);

/// wire() without running: the findings, or none.
Findings check(const Graph& graph, const WiringOptions& options);

}  // namespace trocar
