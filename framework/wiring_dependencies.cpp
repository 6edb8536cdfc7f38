// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>

#include "framework/wiring.hpp"

namespace trocar {
namespace {

bool is_device(const Component& component) {
  return dynamic_cast<const Device*>(&component) != nullptr;
}

}  // namespace

/// Every node that the input's value is computed from. A device ends the search: what it measures
/// is a measurement, whatever moved it.
std::vector<bool> Wiring::upstream(const std::vector<const InputPort*>& inputs) const {
  std::vector<bool> reached(graph_.size(), false);
  std::vector<const InputPort*> open = inputs;
  while (!open.empty()) {
    const InputPort* port = open.back();
    open.pop_back();
    for (const std::size_t w : wires_into(*port)) {
      const ResolvedWire& wire = wires_[w];
      if (reached[wire.from_node]) continue;
      reached[wire.from_node] = true;
      const Component& source = wire.from->owner();
      if (is_device(source)) continue;
      for (const InputPort* next : source.inputs()) open.push_back(next);
    }
  }
  return reached;
}

std::vector<bool> Wiring::upstream(const InputPort& input) const {
  return upstream(std::vector<const InputPort*>{&input});
}

void Wiring::check_truth() {
  for (const auto& component : result_->components_) {
    const auto* device = dynamic_cast<const Device*>(component.get());
    if (device == nullptr) continue;
    for (const InputPort* input : {&device->hold_port(), &device->effort_port()}) {
      const std::vector<bool> reached = upstream(*input);
      for (const ResolvedWire& wire : wires_)
        if (wire.from->truth() &&
            (wire.to == input || (reached[wire.to_node] && !is_device(wire.to->owner()))))
          findings_.add(wire.where,
                        fmt::format("{}: only a simulation knows {}.{}, so nothing that reaches "
                                    "{}.{} may be computed from it; record or plot it instead",
                                    wire.text(), wire.from->owner_name(), wire.from->name(),
                                    device->name(), input->name()));
    }
  }
}

/// Within each thread. What another thread computes says itself, with each value that it sends,
/// whether that may be used.
void Wiring::mark_dependencies() {
  for (RateGroup& group : result_->groups_) {
    const auto mark = [&](const std::vector<bool>& reached, const auto& set) {
      for (const NodeId id : order_)
        if (reached[id] && &group_of(id) == &group) set(group.schedule_[item_index_[id]]);
    };
    for (std::size_t d = 0; d < group.devices_.size(); ++d) {
      const unsigned bit = 1u << d;
      mark(upstream(group.devices_[d]->effort_port()),
           [&](ScheduleItem& item) { item.reaches_effort |= bit; });
      mark(upstream(group.devices_[d]->hold_port()),
           [&](ScheduleItem& item) { item.reaches_hold |= bit; });
    }
    std::map<std::uint64_t, std::vector<const InputPort*>> read;  // for what is sent, by its bit
    for (const Departure& departure : group.departures_) {
      ScheduleItem& maker = group.schedule_[departure.item];
      maker.reaches_crossing |= departure.mask;
      if (is_device(*maker.component)) continue;
      const auto& inputs = maker.component->inputs();
      std::vector<const InputPort*>& all = read[departure.mask];
      all.insert(all.end(), inputs.begin(), inputs.end());
    }
    for (const auto& [mask, inputs] : read)
      mark(upstream(inputs), [bit = mask](ScheduleItem& item) { item.reaches_crossing |= bit; });
  }
}

}  // namespace trocar
