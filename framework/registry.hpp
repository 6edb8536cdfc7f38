// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "framework/component.hpp"
#include "framework/group.hpp"
#include "framework/service.hpp"

namespace trocar {

struct ComponentDefinition;

/// What is known of a component type without making one.
struct ComponentType {
  std::string name;                                  // CamelCase, as scripts call it
  std::string category;                              // "fixtures"
  std::string doc;                                   // one line
  std::function<std::unique_ptr<Component>()> make;  // empty for a group
  std::function<std::unique_ptr<Group>()> make_group;
  std::shared_ptr<const ComponentDefinition> definition{};  // of ports that a script defines
  std::string plugin{};  // that brought it; "" for one of Trocar's own
};

/// The component types and groups that scripts can use, and the services beside them. An object
/// like any other: nothing registers itself behind the reader's back.
class Registry {
 public:
  /// @throw std::invalid_argument when the name is taken or not CamelCase.
  template <typename T>
  void add(std::string_view name, std::string_view category, std::string_view doc) {
    ComponentType type{std::string(name), std::string(category), std::string(doc), {}, {}, {}};
    if constexpr (std::is_base_of_v<Group, T>)
      type.make_group = [] { return std::make_unique<T>(); };
    else
      type.make = [] { return std::make_unique<T>(); };
    add(std::move(type));
  }
  void add(ComponentType type);

  /// @throw std::invalid_argument when the name is taken or not a lowercase word.
  void add(ServiceType service);

  const ComponentType* find(std::string_view name) const;
  std::vector<std::string> names() const;
  /// In the order of registration.
  const std::deque<ComponentType>& types() const { return types_; }
  const std::deque<ServiceType>& services() const { return services_; }

 private:
  std::deque<ComponentType> types_;  // graphs point to its elements
  std::deque<ServiceType> services_;
};

}  // namespace trocar
