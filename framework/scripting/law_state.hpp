// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <lua.hpp>
#include <string>
#include <vector>

#include "framework/realtime/rt_safe.hpp"

namespace trocar::lua {

/// The numbers, true and false of a law's `state`, as its file declares them, tables within it
/// included: what one version of a law hands over to the next.
class LawState {
 public:
  static constexpr std::size_t most = 64;  // numbers, of all versions together
  static constexpr int deepest = 3;        // tables within tables
  using Numbers = std::array<double, most>;

  LawState() = default;
  /// Looks at the table at `index`, which stays there.
  LawState(lua_State* state, int index);

  /// Agrees with other versions on where each number stands among `most`.
  /// @param names so far; new ones are added. What finds no room is not handed over
  void agree(std::vector<std::string>& names);
  /// Numbers as they are, true and false as 1 and 0; NaN where it has none.
  void read(Numbers& numbers) const RT_SAFE;
  /// Those that are not NaN.
  void write(const Numbers& numbers) const RT_SAFE;

 private:
  struct Field {
    std::string name{};               // "torn", "last.x"
    std::vector<std::string> path{};  // of keys
    int type = LUA_TNUMBER;
    std::size_t place = most;  // among the numbers; `most`: none
  };
  void find(int table, const Field& above, int depth);
  bool push_table(const Field& field) const RT_SAFE;

  lua_State* state_ = nullptr;
  int index_ = 0;
  std::vector<Field> fields_;
};

}  // namespace trocar::lua
