// SPDX-License-Identifier: Apache-2.0
#include "framework/component.hpp"

namespace trocar {
namespace {

template <typename T>
T* find_by_name(const std::vector<T*>& all, std::string_view name) {
  for (T* one : all)
    if (one->name() == name) return one;
  return nullptr;
}

}  // namespace

ParameterBase* ParameterSet::find_parameter(std::string_view name) const {
  return find_by_name(parameters_, name);
}

std::vector<std::string> ParameterSet::parameter_names() const {
  std::vector<std::string> names;
  for (const ParameterBase* parameter : parameters_) names.push_back(parameter->name());
  return names;
}

InputPort* Component::find_input(std::string_view name) const {
  return find_by_name(inputs_, name);
}

OutputPort* Component::find_output(std::string_view name) const {
  return find_by_name(outputs_, name);
}

void Component::unify() {
  std::vector<Port*> generic;
  for (InputPort* port : inputs_)
    if (port->generic()) generic.push_back(port);
  for (OutputPort* port : outputs_)
    if (port->generic()) generic.push_back(port);
  for (const Port* known : generic) {
    if (!known->signature()) continue;
    for (Port* port : generic)
      if (!port->signature()) port->set_signature(*known->signature());
    return;
  }
}

}  // namespace trocar
