// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "framework/scripting/script_context.hpp"

namespace trocar::lua {

/// A Lua state with all that a script may use.
class World {
 public:
  /// @param script outlives the world
  /// @throw std::runtime_error when Lua does not start
  explicit World(ScriptContext& script);

  lua_State* state() const { return state_.get(); }
  /// Runs a script's text. @return the error that ended it
  std::optional<std::string> run_text(const std::string& path, const std::string& text);
  /// Calls the function at the top of the stack, without arguments. @return the error that ended it
  std::optional<std::string> call();

 private:
  std::string take_error();

  std::unique_ptr<lua_State, void (*)(lua_State*)> state_;
};

}  // namespace trocar::lua
