// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "framework/scripting/loop_guard.hpp"

namespace trocar::lua {

/// A Lua state of a script's own, for the loop: memory from a pool of its own, the collector
/// stopped but for collect(), a hardened world (loop_world.hpp) and every call under the guard.
class LoopState {
 public:
  /// @param file the script's name, as errors call it
  /// @param seed of math.random
  LoopState(const LoopLimits& limits, std::string_view file, std::uint64_t seed);
  LoopState(const LoopState&) = delete;
  LoopState& operator=(const LoopState&) = delete;

  lua_State* lua() const RT_SAFE { return state_.get(); }
  const LoopGuard& guard() const RT_SAFE { return guard_; }

  /// Runs the script's text; its results stay on the stack.
  /// @return false where it failed: error() says why
  bool run_file(std::string_view text, int results);
  /// Before the first step: collects what loading left, and makes room for calls within calls, so
  /// that a step that allocates nothing itself allocates nothing.
  void settle();
  /// Calls the function below its arguments as a step, protected and watched.
  /// @return false where it failed: error() says why, and the stack is as without the call
  bool call(int arguments, int results) RT_SAFE;
  /// A part of the collector's work, for the slack after a step. How much it does depends on what
  /// steps allocated alone, and a script that allocates nothing costs nothing.
  void collect() RT_SAFE;

  /// "membrane.lua:12: what, and the cure; called at line 30". Lives as long as the state.
  const char* error() const RT_SAFE { return error_.data(); }
  /// Puts a message of the same form there. @param line 0 where there is none
  void set_error(int line, std::string_view message) RT_SAFE;
  /// For errors of a step that are at no line of the file.
  void set_spare_line(int line) { spare_line_ = line; }

 private:
  struct Closer {
    void operator()(lua_State* state) const { lua_close(state); }
  };
  bool finish(int status) RT_SAFE;
  void describe_error() RT_SAFE;
  std::string_view breach_text(char* buffer, std::size_t size) const RT_SAFE;

  LoopGuard guard_;
  std::string file_;
  LoopTrace trace_;  // of the last error that was the script's own
  std::array<char, 1024> error_{};
  int spare_line_ = 0;
  std::size_t uncollected_ = 0;  // [bytes] allocated since the last cycle of the collector began
  bool collecting_ = false;
  std::unique_ptr<lua_State, Closer> state_;
};

}  // namespace trocar::lua
