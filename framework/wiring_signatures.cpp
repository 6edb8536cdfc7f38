// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <numeric>

#include "framework/text.hpp"
#include "framework/wiring.hpp"

namespace trocar {
namespace {

std::optional<Signature> read_signature(const ResolvedWire& wire) {
  if (!wire.from->signature()) return std::nullopt;
  try {
    return select_field(*wire.from->signature(), wire.path).signature;
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // check_wires() reports it
  }
}

/// A generic component computes on numbers.
bool numbers(const Signature& signature) {
  return !signature.type->fields.empty() || signature.type->scalar == Scalar::real;
}

}  // namespace

void Wiring::resolve_signatures() {
  std::vector<std::size_t> all(wires_.size());
  std::iota(all.begin(), all.end(), 0);
  spread_signatures(all);
  settle_natural();
  for (NodeId id = 0; id < graph_.size(); ++id) {
    if (!result_->components_[id]) continue;
    const auto& inputs = result_->components_[id]->inputs();
    const bool excused = std::any_of(inputs.begin(), inputs.end(), [&](const InputPort* input) {
      return graph_.node(id).set_at.contains(input->name());  // given what does not exist
    });
    for (const OutputPort* output : result_->components_[id]->outputs()) {
      if (!output->generic() || (excused && !output->signature())) continue;
      if (!output->signature())
        findings_.add(where_of(id), fmt::format("{}.{} has no type yet: wire it to a port that has",
                                                output->owner_name(), output->name()));
      else if (!numbers(*output->signature()))
        findings_.add(where_of(id), fmt::format("{}.{} cannot carry a {}", output->owner_name(),
                                                output->name(), output->signature()->type->name));
    }
  }
}

/// From these wires on. What a producer says goes before what its consumers ask for. Each component
/// spreads what it learns at once: two of its ports that disagree would both be settled otherwise,
/// and no wire would show it.
void Wiring::spread_signatures(const std::vector<std::size_t>& open) {
  std::vector<std::size_t> forwards = open, backwards = open;
  const auto settle = [&](Port& port, NodeId node, const Signature& signature) {
    if (!port.generic() || port.signature()) return;
    port.set_signature(signature);
    result_->components_[node]->unify();
    for (std::vector<std::size_t>* list : {&forwards, &backwards})
      list->insert(list->end(), wires_of_[node].begin(), wires_of_[node].end());
  };
  for (std::size_t f = 0, b = 0; f < forwards.size() || b < backwards.size();) {
    if (f < forwards.size()) {
      const ResolvedWire& wire = wires_[forwards[f++]];
      if (const auto signature = read_signature(wire)) settle(*wire.to, wire.to_node, *signature);
    } else {
      const ResolvedWire& wire = wires_[backwards[b++]];
      if (wire.to->signature() && wire.path.empty())
        settle(*wire.from, wire.from_node, *wire.to->signature());
    }
  }
}

void Wiring::settle_natural() {
  for (NodeId id = 0; id < graph_.size(); ++id) {
    Component* component = result_->components_[id].get();
    if (component == nullptr) continue;
    for (OutputPort* output : component->outputs()) {
      if (!output->generic() || output->signature()) continue;
      const auto natural = component->natural_signature();
      if (!natural) continue;
      output->set_signature(*natural);
      component->unify();
      spread_signatures(wires_of_[id]);
    }
  }
}

void Wiring::check_wires() {
  for (const ResolvedWire& wire : wires_) {
    if (!wire.from->signature() || !wire.to->signature()) continue;
    try {
      const Signature source = select_field(*wire.from->signature(), wire.path).signature;
      if (const std::string wrong = mismatch(source, *wire.to->signature()); !wrong.empty())
        findings_.add(wire.where, fmt::format("{}: {}", wire.text(), wrong));
    } catch (const std::invalid_argument& error) {
      findings_.add(wire.where, fmt::format("{}: {}", wire.text(), error.what()));
    }
  }
}

}  // namespace trocar
