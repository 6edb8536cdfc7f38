// SPDX-License-Identifier: Apache-2.0
#include "framework/component_definition.hpp"

namespace trocar {

std::unique_ptr<ComponentType> defined_type(const ComponentType& type, const Literal& value,
                                            std::vector<DefinitionMistake>& mistakes) {
  auto make = type.definition->read(value, mistakes);
  if (!make) return nullptr;
  auto defined = std::make_unique<ComponentType>(type);
  defined->make = std::move(make);
  return defined;
}

}  // namespace trocar
