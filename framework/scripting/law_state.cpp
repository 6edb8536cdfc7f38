// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/law_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "framework/scripting/lua_value.hpp"

namespace trocar::lua {

LawState::LawState(lua_State* state, int index) : state_(state), index_(index) {
  if (lua_istable(state, index)) find(index, {}, 0);
}

void LawState::find(int table, const Field& above, int depth) {
  lua_checkstack(state_, 4);
  for (const Key& key : ordered_keys(state_, table)) {
    if (key.number > 0) continue;
    push_value(state_, table, key);
    Field field = above;
    field.name += (above.name.empty() ? "" : ".") + key.text;
    field.path.push_back(key.text);
    field.type = lua_type(state_, -1);
    if (field.type == LUA_TNUMBER || field.type == LUA_TBOOLEAN)
      fields_.push_back(std::move(field));
    else if (field.type == LUA_TTABLE && depth < deepest)
      find(lua_gettop(state_), field, depth + 1);
    lua_pop(state_, 1);
  }
}

void LawState::agree(std::vector<std::string>& names) {
  for (Field& field : fields_) {
    const std::string name = field.name + (field.type == LUA_TBOOLEAN ? "?" : "");
    const auto found = std::find(names.begin(), names.end(), name);
    field.place = static_cast<std::size_t>(found - names.begin());
    if (found == names.end() && names.size() < most) names.push_back(name);
  }
}

/// Pushes the table that holds the field. @return false, and nothing, where it is gone
bool LawState::push_table(const Field& field) const RT_SAFE {
  lua_pushvalue(state_, index_);
  for (std::size_t i = 0; i + 1 < field.path.size(); ++i) {
    lua_pushstring(state_, field.path[i].c_str());
    lua_rawget(state_, -2);
    lua_remove(state_, -2);
    if (lua_istable(state_, -1)) continue;
    lua_pop(state_, 1);
    return false;
  }
  return true;
}

void LawState::read(Numbers& numbers) const RT_SAFE {
  numbers.fill(std::numeric_limits<double>::quiet_NaN());
  for (const Field& field : fields_) {
    if (field.place >= most || !push_table(field)) continue;
    lua_pushstring(state_, field.path.back().c_str());
    lua_rawget(state_, -2);
    if (lua_type(state_, -1) == field.type)
      numbers[field.place] =
          field.type == LUA_TBOOLEAN ? lua_toboolean(state_, -1) : lua_tonumber(state_, -1);
    lua_pop(state_, 2);
  }
}

void LawState::write(const Numbers& numbers) const RT_SAFE {
  for (const Field& field : fields_) {
    if (field.place >= most || std::isnan(numbers[field.place]) || !push_table(field)) continue;
    lua_pushstring(state_, field.path.back().c_str());
    if (field.type == LUA_TBOOLEAN)
      lua_pushboolean(state_, numbers[field.place] != 0.0);
    else
      lua_pushnumber(state_, numbers[field.place]);
    lua_rawset(state_, -3);
    lua_pop(state_, 1);
  }
}

}  // namespace trocar::lua
