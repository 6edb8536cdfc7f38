// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "framework/device.hpp"
#include "framework/graph.hpp"

namespace trocar {

struct WiringOptions {
  double rate = 1000.0;    // [Hz] of the thread
  std::uint64_t seed = 1;  // of everything random
  Graph::Overrides set{};  // for this run only; win over the script's values
};

/// One component in the order of the schedule.
struct ScheduleItem {
  Component* component = nullptr;
  std::int64_t divider = 1;  // steps at ticks phase, phase + divider, …
  std::int64_t phase = 0;
  std::size_t begin = 0;  // its outputs' numbers in the graph's memory: [begin, end)
  std::size_t end = 0;
  unsigned reaches_effort = 0;  // bit d: what the d-th device renders is computed from it
  unsigned reaches_hold = 0;    // bit d: what holds the d-th device is
};

/// A graph whose components exist, are wired, checked, ordered and configured: ready to run once.
/// All outputs live in one block of memory, numbers first, so that a tick's values are looked
/// through and recorded in one pass.
class WiredGraph {
 public:
  const std::vector<ScheduleItem>& schedule() const { return schedule_; }
  const std::vector<Device*>& devices() const { return devices_; }
  /// By the graph's node; null for a group.
  Component* component(NodeId node) const { return components_[node].get(); }
  Component* find(std::string_view name) const;
  double period() const { return period_; }
  std::int64_t period_ns() const { return period_ns_; }
  /// All numbers of all outputs.
  std::span<const double> numbers() const { return {memory_.data(), number_count_}; }
  /// Where a placed output begins in the memory [bytes].
  std::size_t offset_of(const OutputPort& output) const;
  const std::byte* memory() const { return reinterpret_cast<const std::byte*>(memory_.data()); }
  std::size_t memory_size() const { return memory_.size() * sizeof(double); }
  /// The parameters that move when this one is edited: itself and those that follow it.
  std::vector<ParameterBase*> followers(const Graph& graph, const ParameterRef& parameter) const;

 private:
  friend class Wiring;
  std::vector<std::unique_ptr<Component>> components_;
  std::vector<std::unique_ptr<ParameterSet>> groups_;
  std::vector<ScheduleItem> schedule_;
  std::vector<Device*> devices_;
  std::vector<double> memory_;
  std::size_t number_count_ = 0;
  double period_ = 0.0;
  std::int64_t period_ns_ = 0;
};

/// Builds the components of a graph, resolves generic ports, checks everything (types, units,
/// frames, missing inputs, double drivers, loops, rates, limits, what only a simulation knows) and
/// configures in order.
/// @throw BrokenGraph with every finding, the graph's own included.
std::unique_ptr<WiredGraph> wire(const Graph& graph, const WiringOptions& options);

/// wire() without running: the findings, or none.
Findings check(const Graph& graph, const WiringOptions& options);

}  // namespace trocar
