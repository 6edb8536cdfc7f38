// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "framework/scripting/script_context.hpp"
#include "framework/scripting/spec.hpp"

namespace trocar::lua {

/// What `describe`, `it` and `expect` share; one for each time that a spec file is read.
struct SpecContext {
  /// A `describe`; the file itself is the outermost.
  struct Level {
    std::string name;
    std::vector<int> before{};  // functions of `before_each`, in Lua's registry
  };

  std::optional<std::size_t> wanted{};  // which test is to run; none: the file is only listed
  std::vector<std::shared_ptr<Level>> levels{std::make_shared<Level>()};
  std::vector<SpecTest> tests{};
  int body = LUA_NOREF;                               // of the wanted test
  std::vector<std::shared_ptr<Level>> around_body{};  // its levels
  bool testing = false;                               // the body runs
  std::size_t expectations = 0;
  std::vector<SpecFailure> failures{};
};

/// Opens expect(); its methods are in files of their own.
void open_expect(lua_State* state);

/// What expect() was given, at the index of a method's first argument: pushed.
void push_expected_value(lua_State* state);
/// The signal that expect() was given.
/// @throw std::invalid_argument for anything else
const SignalRef& expected_signal(lua_State* state, const char* method);

/// Notes the failure and ends the test.
int fail(lua_State* state, SpecFailure failure);

// Methods of what expect() returns.
extern const luaL_Reg value_expectations[];
extern const luaL_Reg signal_expectations[];

}  // namespace trocar::lua
