// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "framework/scripting/law_file.hpp"

namespace trocar::lua {

/// One number of a port, as it crosses between the framework's memory and Lua.
struct LawNumber {
  enum class Kind { real, integer, boolean, label };
  Kind kind = Kind::real;
  std::size_t port = 0;
  std::size_t offset = 0;  // [bytes] in the port's value
  std::string name{};      // "out.force.x"
};

/// The chunk of Lua that stands between the loop and a law's step. Numbers cross on the stack, and
/// Lua itself puts them into tables that exist from the beginning: that costs a fifth of what the
/// C API does for it, and nothing is allocated.
///
/// The chunk takes the definition, the table of parameters' values, the world's functions and the
/// lists of labels. It returns a function of the numbers of inputs that calls step and returns
/// the numbers of outputs, and the table of state.
struct LawShim {
  std::string text;
  bool wants_tick = false;  // time and dt are the first arguments then
  std::vector<LawNumber> inputs{};
  std::vector<LawNumber> outputs{};
  std::vector<std::vector<std::string>> labels{};

  /// @param step_parameters how many step takes: with a fifth it gets the tick
  /// @throw std::invalid_argument for more numbers than Lua passes
  LawShim(const LawFile& file, int step_parameters);
};

}  // namespace trocar::lua
