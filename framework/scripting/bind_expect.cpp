// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/scripting/run_options.hpp"
#include "framework/scripting/spec_context.hpp"
#include "framework/signal_checks.hpp"
#include "framework/text.hpp"

namespace trocar::lua {
namespace {

constexpr const char* metatable = "trocar.expectation";

std::string text_at(lua_State* state, int index) {
  if (lua_type(state, index) == LUA_TTABLE || lua_type(state, index) == LUA_TSTRING)
    return to_literal(state, index).text();
  std::string text = luaL_tolstring(state, index, nullptr);
  lua_pop(state, 1);
  return text;
}

/// A number as it is, a text as a quantity in SI.
double number_at(lua_State* state, int index, const char* method) {
  if (lua_type(state, index) == LUA_TNUMBER) return lua_tonumber(state, index);
  if (lua_type(state, index) == LUA_TSTRING)
    return parse_quantity(lua_tostring(state, index)).value;
  throw std::invalid_argument(fmt::format("{} needs a number or a quantity like \"5 N\", not {}",
                                          method, text_at(state, index)));
}

double expected_number(lua_State* state, const char* method) {
  push_expected_value(state);
  if (lua_type(state, -1) != LUA_TNUMBER)
    throw std::invalid_argument(
        fmt::format("expect({}):{} is for numbers", text_at(state, -1), method));
  const double number = lua_tonumber(state, -1);
  lua_pop(state, 1);
  return number;
}

int fail_value(lua_State* state, std::string expected, std::string got) {
  return fail(state, {.expected = std::move(expected), .got = std::move(got)});
}

/// Numbers exactly, tables part by part.
bool equal_values(lua_State* state, int a, int b, int depth) {
  if (lua_type(state, a) != LUA_TTABLE || lua_type(state, b) != LUA_TTABLE)
    return lua_compare(state, a, b, LUA_OPEQ) != 0;
  constexpr int deepest = 16;
  luaL_checkstack(state, 4, "nested tables");
  const int left = lua_absindex(state, a), right = lua_absindex(state, b);
  const std::vector<Key> keys = ordered_keys(state, left), others = ordered_keys(state, right);
  if (depth == deepest || keys.size() != others.size()) return false;
  return std::all_of(keys.begin(), keys.end(), [&](const Key& key) {
    push_value(state, left, key);
    push_value(state, right, key);
    const bool equal = equal_values(state, -2, -1, depth + 1);
    lua_pop(state, 2);
    return equal;
  });
}

/// expect(x):equals(y)
int equals(lua_State* state) {
  lua_settop(state, 2);
  push_expected_value(state);
  if (equal_values(state, 3, 2, 0)) return 0;
  return fail_value(state, text_at(state, 2), text_at(state, 3));
}

/// expect(x):is("<=", "5 N")
int is(lua_State* state) {
  const double value = expected_number(state, "is");
  const std::string operation = luaL_checkstring(state, 2);
  const auto comparison = comparison_named(operation);
  if (!comparison)
    throw std::invalid_argument(
        fmt::format("is(\"{}\", …): needs one of {}", operation, join(comparison_names(), "  ")));
  const double bound = number_at(state, 3, "is");
  if (std::isfinite(value) && compare(value, *comparison, bound)) return 0;
  return fail_value(state, fmt::format("{} {:.12g}", operation, bound),
                    fmt::format("{:.12g}", value));
}

/// expect(x):near("5 N", { within = "0.1 N" }); within = "2 %" is of what is expected
int near(lua_State* state) {
  const double value = expected_number(state, "near");
  const double target = number_at(state, 2, "near");
  if (!lua_istable(state, 3) || lua_getfield(state, 3, "within") == LUA_TNIL)
    throw std::invalid_argument("near needs within, e.g. near(\"5 N\", { within = \"1 %\" })");
  double band = number_at(state, -1, "within");
  if (lua_type(state, -1) == LUA_TSTRING &&
      parse_quantity(lua_tostring(state, -1)).unit.symbol == "%")
    band *= std::abs(target);
  if (std::abs(value - target) <= band) return 0;
  return fail_value(state, fmt::format("{:.12g} within {:.6g}", target, band),
                    fmt::format("{:.12g}, {:.6g} away", value, std::abs(value - target)));
}

/// expect(list):empty(), expect(text):empty()
int empty(lua_State* state) {
  lua_settop(state, 1);
  push_expected_value(state);
  const bool is_text = lua_type(state, 2) == LUA_TSTRING;
  if (!is_text && !lua_istable(state, 2))
    throw std::invalid_argument(
        fmt::format("expect({}):empty() is for tables and texts", text_at(state, 2)));
  const bool holds = is_text ? lua_rawlen(state, 2) == 0 : ordered_keys(state, 2).empty();
  return holds ? 0 : fail_value(state, "empty", text_at(state, 2));
}

/// expect(text):contains("part"); in a list, a text that contains it
int contains(lua_State* state) {
  lua_settop(state, 2);
  const std::string part = luaL_checkstring(state, 2);
  push_expected_value(state);
  bool found = false;
  if (lua_istable(state, 3)) {
    for (const Key& key : ordered_keys(state, 3)) {
      push_value(state, 3, key);
      found = found || text_at(state, -1).find(part) != std::string::npos;
      lua_pop(state, 1);
    }
  } else {
    found = text_at(state, 3).find(part) != std::string::npos;
  }
  return found ? 0 : fail_value(state, fmt::format("contains \"{}\"", part), text_at(state, 3));
}

/// expect(function() … end):fails("part of the message")
int fails(lua_State* state) {
  lua_settop(state, 2);
  const std::string part = luaL_optstring(state, 2, "");
  push_expected_value(state);
  if (!lua_isfunction(state, 3))
    throw std::invalid_argument("fails is for functions: expect(function() … end):fails(\"why\")");
  const std::string expected = fmt::format("an error with \"{}\"", part);
  const std::size_t failures = context(state).spec->failures.size();
  if (lua_pcall(state, 0, 0, 0) == LUA_OK) return fail_value(state, expected, "no error");
  if (context(state).spec->failures.size() > failures) return lua_error(state);  // an inner expect
  const std::string message = text_at(state, -1);
  return message.find(part) != std::string::npos ? 0 : fail_value(state, expected, message);
}

int expectation_index(lua_State* state) {
  const std::string name = luaL_checkstring(state, 2);
  std::vector<std::string> known;
  for (const luaL_Reg* methods : {value_expectations, signal_expectations})
    for (const luaL_Reg* method = methods; method->name != nullptr; ++method) {
      known.emplace_back(method->name);
      if (name != method->name) continue;
      lua_pushcfunction(state, method->func);
      return 1;
    }
  return luaL_error(state, "expect has no \"%s\"%s", name.c_str(), suggestion(name, known).c_str());
}

int expect(lua_State* state) {
  SpecContext& spec = *context(state).spec;
  if (lua_gettop(state) == 0) throw std::invalid_argument("expect() needs what is to be judged");
  if (get<Placeholder>(state, 1) != nullptr)
    throw std::invalid_argument("expect() got something that does not exist");
  ++spec.expectations;
  lua_settop(state, 1);
  lua_newuserdatauv(state, 0, 1);
  lua_insert(state, 1);
  lua_setiuservalue(state, 1, 1);
  luaL_setmetatable(state, metatable);
  return 1;
}

}  // namespace

const luaL_Reg value_expectations[] = {{"equals", guarded<equals>},
                                       {"is", guarded<is>},
                                       {"near", guarded<near>},
                                       {"empty", guarded<empty>},
                                       {"contains", guarded<contains>},
                                       {"fails", guarded<fails>},
                                       {nullptr, nullptr}};

void push_expected_value(lua_State* state) {
  if (luaL_testudata(state, 1, metatable) == nullptr)
    throw std::invalid_argument("a method is called with a colon: expect(x):equals(y)");
  lua_getiuservalue(state, 1, 1);
}

const SignalRef& expected_signal(lua_State* state, const char* method) {
  push_expected_value(state);
  const auto* signal = get<SignalRef>(state, -1);
  if (signal == nullptr)
    throw std::invalid_argument(
        fmt::format("expect({}):{} is for signals, e.g. expect(run[\"wall.force.z\"])",
                    text_at(state, -1), method));
  lua_pop(state, 1);
  return *signal;
}

int fail(lua_State* state, SpecFailure failure) {
  failure.where = where(state);
  const std::string text = failure.text();
  context(state).spec->failures.push_back(std::move(failure));
  return luaL_error(state, "%s", text.c_str());
}

void open_expect(lua_State* state) {
  luaL_newmetatable(state, metatable);
  lua_pushcfunction(state, guarded<expectation_index>);
  lua_setfield(state, -2, "__index");
  lua_pop(state, 1);
  lua_pushcfunction(state, guarded<expect>);
  lua_setglobal(state, "expect");
}

}  // namespace trocar::lua
