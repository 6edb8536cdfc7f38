// SPDX-License-Identifier: Apache-2.0
#include "framework/registry.hpp"

#include <fmt/format.h>

#include <cctype>
#include <stdexcept>

#include "framework/text.hpp"

namespace trocar {

void Registry::add(ComponentType type) {
  if (!is_name(type.name) || !std::isupper(static_cast<unsigned char>(type.name.front())))
    throw std::invalid_argument(
        fmt::format("component type \"{}\": a CamelCase name is needed, e.g. \"Wall\"", type.name));
  if (find(type.name) != nullptr)
    throw std::invalid_argument(fmt::format("component type \"{}\" exists already", type.name));
  types_.push_back(std::move(type));
}

void Registry::add(ServiceType service) {
  if (!is_name(service.name) || !std::islower(static_cast<unsigned char>(service.name.front())))
    throw std::invalid_argument(
        fmt::format("service \"{}\": a lowercase word is needed, e.g. \"foxglove\"", service.name));
  for (const ServiceType& other : services_)
    if (other.name == service.name)
      throw std::invalid_argument(fmt::format("service \"{}\" exists already", service.name));
  services_.push_back(std::move(service));
}

const ComponentType* Registry::find(std::string_view name) const {
  for (const ComponentType& type : types_)
    if (type.name == name) return &type;
  return nullptr;
}

std::vector<std::string> Registry::names() const {
  std::vector<std::string> names;
  for (const ComponentType& type : types_) names.push_back(type.name);
  return names;
}

}  // namespace trocar
