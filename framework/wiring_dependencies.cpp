// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "framework/wiring.hpp"

namespace trocar {
namespace {

bool is_device(const Component& component) {
  return dynamic_cast<const Device*>(&component) != nullptr;
}

}  // namespace

/// Every node that the input's value is computed from. A device ends the search: what it measures
/// is a measurement, whatever moved it.
std::vector<bool> Wiring::upstream(const InputPort& input) const {
  std::vector<bool> reached(graph_.size(), false);
  std::vector<const InputPort*> open = {&input};
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

void Wiring::mark_dependencies() {
  for (std::size_t d = 0; d < result_->devices_.size(); ++d) {
    const unsigned bit = 1u << d;
    const std::vector<bool> effort = upstream(result_->devices_[d]->effort_port());
    const std::vector<bool> hold = upstream(result_->devices_[d]->hold_port());
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (effort[order_[i]]) result_->schedule_[i].reaches_effort |= bit;
      if (hold[order_[i]]) result_->schedule_[i].reaches_hold |= bit;
    }
  }
}

}  // namespace trocar
