// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "framework/least_squares.hpp"
#include "framework/scripting/run_columns.hpp"

namespace trocar::lua {
namespace {

std::size_t stride_at(lua_State* state, int table) {
  lua_getfield(state, table, "every");
  const double every = lua_isnil(state, -1) ? 1.0 : lua_tonumber(state, -1);
  lua_pop(state, 1);
  if (!(every >= 1.0 && every < 1e9) || std::floor(every) != every)
    throw std::invalid_argument(
        fmt::format("run:samples: every = {:g}: needs a whole number of rows, 1 or more", every));
  return static_cast<std::size_t>(every);
}

std::vector<double> numbers_at(lua_State* state, int index, const std::string& what) {
  if (!lua_istable(state, index))
    throw std::invalid_argument(what + " needs a list of numbers, e.g. of run:samples");
  const int list = lua_absindex(state, index);
  std::vector<double> numbers(static_cast<std::size_t>(luaL_len(state, list)));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    lua_rawgeti(state, list, static_cast<lua_Integer>(i + 1));
    if (lua_type(state, -1) != LUA_TNUMBER)
      throw std::invalid_argument(fmt::format("{}: entry {} is no number", what, i + 1));
    numbers[i] = lua_tonumber(state, -1);
    lua_pop(state, 1);
  }
  return numbers;
}

void set_list(lua_State* state, const char* name, const std::vector<double>& numbers) {
  lua_createtable(state, static_cast<int>(numbers.size()), 0);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    lua_pushnumber(state, numbers[i]);
    lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_setfield(state, -2, name);
}

/// trocar.least_squares { columns = { {…}, … }, target = {…} }
int least_squares(lua_State* state) {
  if (!lua_istable(state, 1))
    throw std::invalid_argument(
        "trocar.least_squares takes one table, e.g. { columns = { x }, target = y }");
  std::vector<std::vector<double>> columns;
  if (lua_getfield(state, 1, "columns") != LUA_TTABLE)
    throw std::invalid_argument("trocar.least_squares needs columns = { {…}, … }");
  for (lua_Integer i = 1; i <= luaL_len(state, -1); ++i) {
    lua_rawgeti(state, -1, i);
    columns.push_back(numbers_at(state, -1, fmt::format("trocar.least_squares: column {}", i)));
    lua_pop(state, 1);
  }
  lua_getfield(state, 1, "target");
  const std::vector<double> target = numbers_at(state, -1, "trocar.least_squares: target");
  lua_pop(state, 2);
  const LinearFit fit = fit_linear(columns, target);
  lua_newtable(state);
  set_list(state, "solution", fit.solution);
  set_list(state, "errors", fit.errors);
  for (const auto& [name, value] : {std::pair{"rms", fit.rms}, std::pair{"r2", fit.r2}}) {
    lua_pushnumber(state, value);
    lua_setfield(state, -2, name);
  }
  return 1;
}

}  // namespace

int samples(lua_State* state) {
  const RowStore& rows = rows_of(state);
  const Column signal = scalar(rows, signal_at(state, 2));
  const bool chosen = lua_istable(state, 3);
  if (!chosen && !lua_isnoneornil(state, 3))
    throw std::invalid_argument(
        "run:samples takes a signal and a table, e.g. (spring.stretch, { from = \"1 s\" })");
  if (!chosen) {
    lua_settop(state, 2);
    lua_newtable(state);
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double from = time_field(state, 3, "from", -infinity);
  const double to = time_field(state, 3, "to", infinity);
  const std::size_t every = stride_at(state, 3);
  std::vector<double> where;
  if (lua_getfield(state, 3, "where") != LUA_TNIL) {
    Column which = scalar(rows, signal_at(state, -1));
    if (which.group != signal.group)
      throw std::invalid_argument("run:samples: `where` is of another thread than the signal");
    where = std::move(which.values);
  }
  lua_pop(state, 1);
  const std::vector<double> time = rows.time(signal.group);
  lua_newtable(state);
  lua_Integer count = 0;
  for (std::size_t i = 0; i < signal.values.size(); i += every) {
    if (time[i] < from || time[i] > to || (!where.empty() && where[i] == 0.0)) continue;
    lua_pushnumber(state, signal.values[i]);
    lua_rawseti(state, -2, ++count);
  }
  return 1;
}

int discard(lua_State* state) {
  self<RunRef>(state, "run:discard()").run->result.rows->discard();
  return 0;
}

void open_least_squares(lua_State* state) {
  lua_pushcfunction(state, guarded<least_squares>);
  lua_setfield(state, -2, "least_squares");
}

}  // namespace trocar::lua
