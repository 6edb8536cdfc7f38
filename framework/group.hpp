// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "framework/parameter_set.hpp"

namespace trocar {

class GroupScope;

/// A graph with parameters, inputs, outputs and sites of its own, used as if it were a component.
class Group : public ParameterSet {
 public:
  /// Adds its parts to the scope, wires them and exports what the outside may use.
  virtual void build(GroupScope& scope) = 0;
};

}  // namespace trocar
