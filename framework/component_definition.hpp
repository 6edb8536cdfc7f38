// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "framework/literal.hpp"
#include "framework/registry.hpp"

namespace trocar {

/// What is wrong with a definition, and where in it: the names that lead there.
struct DefinitionMistake {
  std::vector<std::string> path{};  // "fields", "translation", "x"
  std::string message;
};

/// How the ports of a type's components follow from one entry of their table in a script, each
/// component's from its own. The entry is read before the component is made, and so before anything
/// is wired to it.
struct ComponentDefinition {
  using Make = std::function<std::unique_ptr<Component>()>;
  struct Shipped {
    std::string name;
    std::string text;  // Lua that returns the entry's value
  };

  std::string entry;               // "layout"
  std::string doc;                 // one line
  std::string example;             // as a script would write it: "\"space_navigator\""
  std::vector<Shipped> shipped{};  // values that have a name
  /// What makes components of that definition. Each mistake is added, and then it is empty.
  std::function<Make(const Literal& value, std::vector<DefinitionMistake>& mistakes)> read;
};

/// The type of the components that `value` defines; null, and mistakes, where it is wrong.
/// @param type has a definition
std::unique_ptr<ComponentType> defined_type(const ComponentType& type, const Literal& value,
                                            std::vector<DefinitionMistake>& mistakes);

}  // namespace trocar
