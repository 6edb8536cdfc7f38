// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/lua_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "framework/scripting/bounded_text.hpp"
#include "framework/scripting/loop_definition.hpp"
#include "framework/scripting/loop_world.hpp"

namespace trocar::lua {
namespace {

// What stays on the stack, above the message handler.
constexpr int values_index = 2;  // the parameters' values
constexpr int shim_index = 3;
constexpr int state_index = 4;  // the script's state, for who takes it over

template <typename T>
T load_as(const std::byte* at) RT_SAFE {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

}  // namespace

LuaLaw::LuaLaw(const LawFile& file, const LoopLimits& limits, std::uint64_t seed, LawMemory memory)
    : file_(file), memory_(std::move(memory)), state_(limits, file.name, seed) {
  load();
  state_.settle();
}

void LuaLaw::load() {
  lua_State* state = state_.lua();
  if (!load_definition(state_, file_.kind, file_.text)) throw std::invalid_argument(state_.error());
  const int definition = lua_gettop(state);
  lua_getfield(state, definition, "step");
  lua_Debug step;
  lua_getinfo(state, ">u", &step);
  shim_ = std::make_unique<LawShim>(file_, step.nparams);

  lua_newtable(state);  // stays as values_index
  const int values = lua_gettop(state);
  for (const ParameterBase* parameter : memory_.parameters) {
    push_parameter(*parameter);
    lua_setfield(state, values, parameter->name().c_str());
  }
  for (ParameterBase* parameter : memory_.parameters)
    for (const double& number : parameter->numbers())
      known_.push_back({&number, number, parameter});

  if (luaL_loadbufferx(state, shim_->text.data(), shim_->text.size(), "=(trocar)", "t") != LUA_OK)
    throw std::logic_error(lua_tostring(state, -1));
  lua_pushvalue(state, definition);
  lua_pushvalue(state, values);
  lua_getfield(state, LUA_REGISTRYINDEX, "trocar");
  push_labels();
  if (lua_pcall(state, 3 + static_cast<int>(shim_->labels.size()), 2, 0) != LUA_OK)
    throw std::invalid_argument(fmt::format("{}: {}", file_.name, lua_tostring(state, -1)));
  lua_remove(state, definition);
  state_.set_spare_line(file_.step_line);
  lua_checkstack(state, 300);
  kept_ = LawState(state, state_index);
  for (const LawNumber& number : shim_->outputs)
    outputs_.push_back({number.kind, memory_.outputs[number.port] + number.offset, 0.0, 0});
  for (const LawNumber& number : shim_->inputs)
    inputs_.push_back({number.kind, memory_.inputs[number.port] + number.offset});
}

/// One list for each Enumeration, both ways: by number and by label.
void LuaLaw::push_labels() {
  lua_State* state = state_.lua();
  for (const std::vector<std::string>& labels : shim_->labels) {
    lua_newtable(state);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const auto number = static_cast<lua_Integer>(i + 1);
      lua_pushstring(state, labels[i].c_str());
      lua_rawseti(state, -2, number);
      lua_pushinteger(state, number);
      lua_setfield(state, -2, labels[i].c_str());
    }
  }
}

void LuaLaw::push_parameter(const ParameterBase& parameter) {
  lua_State* state = state_.lua();
  if (const auto* number = dynamic_cast<const Parameter<double>*>(&parameter)) {
    lua_pushnumber(state, **number);
  } else if (const auto* vector = dynamic_cast<const Parameter<Vector3>*>(&parameter)) {
    push_world_function(state, "vec");
    for (const double part : {(*vector)->x, (*vector)->y, (*vector)->z})
      lua_pushnumber(state, part);
    lua_call(state, 3, 1);
  } else if (const auto* flag = dynamic_cast<const Parameter<bool>*>(&parameter)) {
    lua_pushboolean(state, **flag);
  } else if (const auto* text = dynamic_cast<const Parameter<std::string>*>(&parameter)) {
    lua_pushstring(state, (*text)->c_str());
  } else {
    push_literal(state, *static_cast<const Parameter<Literal>&>(parameter));
  }
}

/// A live edit moves numbers only.
void LuaLaw::follow_parameters() RT_SAFE {
  for (Known& known : known_)
    if (*known.now != known.told) {
      known.told = *known.now;
      tell(*known.parameter);
    }
}

/// The numbers of a vector go into the vector that Lua has.
void LuaLaw::tell(const ParameterBase& parameter) RT_SAFE {
  lua_State* state = state_.lua();
  const auto* vector = dynamic_cast<const Parameter<Vector3>*>(&parameter);
  if (vector == nullptr) {
    lua_pushnumber(state, *static_cast<const Parameter<double>&>(parameter));
    lua_setfield(state, values_index, parameter.name().c_str());
    return;
  }
  lua_getfield(state, values_index, parameter.name().c_str());
  lua_pushnumber(state, (*vector)->x);
  lua_setfield(state, -2, "x");
  lua_pushnumber(state, (*vector)->y);
  lua_setfield(state, -2, "y");
  lua_pushnumber(state, (*vector)->z);
  lua_setfield(state, -2, "z");
  lua_pop(state, 1);
}

int LuaLaw::push_arguments(const Tick& tick) RT_SAFE {
  lua_State* state = state_.lua();
  int count = 0;
  if (shim_->wants_tick) {
    lua_pushnumber(state, tick.time);
    lua_pushnumber(state, tick.dt);
    count = 2;
  }
  for (const Input& input : inputs_)
    if (input.kind == LawNumber::Kind::real) [[likely]]
      lua_pushnumber(state, load_as<double>(input.at));
    else
      push_other(input);
  return count + static_cast<int>(inputs_.size());
}

void LuaLaw::push_other(const Input& input) RT_SAFE {
  lua_State* state = state_.lua();
  if (input.kind == LawNumber::Kind::boolean)
    lua_pushboolean(state, load_as<bool>(input.at));
  else
    lua_pushinteger(
        state, load_as<std::int64_t>(input.at) + (input.kind == LawNumber::Kind::label ? 1 : 0));
}

bool LuaLaw::evaluate(const Tick& tick) RT_SAFE {
  follow_parameters();
  lua_pushvalue(state_.lua(), shim_index);
  const int arguments = push_arguments(tick);
  if (!state_.call(arguments, static_cast<int>(outputs_.size()))) return false;
  const bool right = read_outputs();
  lua_settop(state_.lua(), state_index);
  return right;
}

bool LuaLaw::read_other(Value& value, int index) RT_SAFE {
  lua_State* state = state_.lua();
  if (value.kind == LawNumber::Kind::boolean) {
    value.whole = lua_toboolean(state, index);
    return lua_type(state, index) == LUA_TBOOLEAN;
  }
  if (lua_type(state, index) != LUA_TNUMBER) return false;
  int is_whole = 1;
  value.whole = lua_tointegerx(state, index, &is_whole);
  if (value.kind == LawNumber::Kind::label) --value.whole;
  return is_whole != 0;
}

/// All of them, before any is written.
bool LuaLaw::read_outputs() RT_SAFE {
  lua_State* state = state_.lua();
  int index = state_index;
  for (Value& value : outputs_) {
    ++index;
    bool right = false;
    if (value.kind == LawNumber::Kind::real) [[likely]] {
      value.real = lua_tonumber(state, index);
      right = std::isfinite(value.real) && lua_type(state, index) == LUA_TNUMBER;
    } else {
      right = read_other(value, index);
    }
    if (right) continue;
    refuse(shim_->outputs[static_cast<std::size_t>(index - state_index - 1)], index);
    return false;
  }
  return true;
}

void LuaLaw::refuse(const LawNumber& number, int index) RT_SAFE {
  lua_State* state = state_.lua();
  char shown[48] = "nil";
  const int type = lua_type(state, index);
  if (type == LUA_TNUMBER)
    std::snprintf(shown, sizeof shown, "%.6g", lua_tonumber(state, index));
  else if (type == LUA_TSTRING)
    std::snprintf(shown, sizeof shown, "\"%.40s\"", lua_tostring(state, index));
  else if (type == LUA_TBOOLEAN)
    std::snprintf(shown, sizeof shown, "%s", lua_toboolean(state, index) != 0 ? "true" : "false");
  else if (type != LUA_TNIL)
    std::snprintf(shown, sizeof shown, "a %s", lua_typename(state, type));
  const LawPort& port = file_.outputs[number.port];
  char text[256];
  std::string_view message;
  switch (number.kind) {
    case LawNumber::Kind::boolean:
      message = print(text, "{} = {}: needs true or false", number.name, shown);
      break;
    case LawNumber::Kind::integer:
      message =
          print(text, "{} = {}: needs a whole number: math.floor makes one", number.name, shown);
      break;
    case LawNumber::Kind::label:
      message = print(text, "{} has to be one of its labels, e.g. \"{}\"", number.name,
                      port.labels.front());
      break;
    case LawNumber::Kind::real:
      if (type == LUA_TNUMBER)
        message = print(text,
                        "{} = {} is not finite: look for a division by 0, or the root of a "
                        "number below 0",
                        number.name, shown);
      else
        message =
            print(text, "{} = {}: needs a plain number, in {}", number.name, shown,
                  port.unit.empty() ? std::string_view("SI") : std::string_view(port.si_unit));
      break;
  }
  state_.set_error(0, message);
}

void LuaLaw::follow(const std::vector<ParameterBase*>& parameters) {
  memory_.parameters = parameters;
  std::size_t at = 0;
  for (ParameterBase* parameter : parameters)
    for (const double& number : parameter->numbers()) {
      known_[at].now = &number;
      known_[at++].parameter = parameter;
    }
}

void LuaLaw::commit() RT_SAFE {
  for (const Value& value : outputs_) write(value, value.real);
}

void LuaLaw::commit(const OutputRamp& ramp) RT_SAFE {
  for (std::size_t i = 0; i < outputs_.size(); ++i)
    write(outputs_[i], outputs_[i].real + ramp.add(i));
}

inline void LuaLaw::write(const Value& value, double real) RT_SAFE {
  switch (value.kind) {
    case LawNumber::Kind::real:
      std::memcpy(value.at, &real, sizeof real);
      break;
    case LawNumber::Kind::boolean: {
      const bool flag = value.whole != 0;
      std::memcpy(value.at, &flag, sizeof flag);
      break;
    }
    case LawNumber::Kind::integer:
    case LawNumber::Kind::label:
      std::memcpy(value.at, &value.whole, sizeof value.whole);
      break;
  }
}

}  // namespace trocar::lua
