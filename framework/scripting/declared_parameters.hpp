// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "framework/literal.hpp"
#include "framework/parameter_set.hpp"
#include "framework/scripting/lua_value.hpp"

namespace trocar::lua {

/// What a script wrote for a parameter of its own: name = { initial, range = { min, max },
/// doc = "…" }.
struct DeclaredParameter {
  std::string name;
  Literal initial{};
  std::string min{};
  std::string max{};
  std::string doc{};
};

/// Reads one from the table at the top of the stack.
DeclaredParameter read_declared_parameter(lua_State* state, const std::string& name);

/// Parameters that exist because a script says so.
class DeclaredParameters {
 public:
  /// Declares it with the type of its initial value: a quantity is a live number with that unit, a
  /// list of three a live vector (where `vectors`), true and false a flag, another text a text;
  /// anything else stays what it is.
  /// @throw std::invalid_argument where the initial value or the range makes no sense
  void declare(ParameterSet& owner, const DeclaredParameter& parameter, bool vectors = false);

 private:
  std::vector<std::unique_ptr<ParameterBase>> own_;
};

}  // namespace trocar::lua
