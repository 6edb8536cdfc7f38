// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/declared_parameters.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace trocar::lua {
namespace {

std::optional<Quantity> as_quantity(const Literal& literal) {
  if (const auto* number = literal.as<double>()) return Quantity{*number, {}};
  const auto* text = literal.as<std::string>();
  if (text == nullptr) return std::nullopt;
  try {
    return parse_quantity(*text);
  } catch (const UnitError&) {
    return std::nullopt;
  }
}

/// The unit of the first of three quantities that has one; nothing where they are none.
std::optional<std::string> unit_of_vector(const Literal& literal) {
  const auto* list = literal.as<Literal::List>();
  if (list == nullptr || list->size() != 3) return std::nullopt;
  std::string unit;
  for (const Literal& part : *list) {
    const auto quantity = as_quantity(part);
    if (!quantity) return std::nullopt;
    if (unit.empty()) unit = si_symbol(quantity->unit.dimension);
  }
  return unit;
}

std::string text_of(const Literal& literal) {
  const auto* text = literal.as<std::string>();
  return text != nullptr ? *text : literal.text();
}

std::string string_field(lua_State* state, const char* name) {
  lua_getfield(state, -1, name);
  const Literal field = to_literal(state, -1);
  lua_pop(state, 1);
  return field.as<std::monostate>() != nullptr ? "" : text_of(field);
}

}  // namespace

DeclaredParameter read_declared_parameter(lua_State* state, const std::string& name) {
  DeclaredParameter parameter{.name = name};
  parameter.doc = string_field(state, "doc");
  lua_getfield(state, -1, "range");
  if (const Literal range = to_literal(state, -1); const auto* list = range.as<Literal::List>()) {
    if (!list->empty()) parameter.min = text_of(list->front());
    if (list->size() > 1) parameter.max = text_of((*list)[1]);
  }
  lua_pop(state, 1);
  lua_rawgeti(state, -1, 1);
  parameter.initial = to_literal(state, -1);
  lua_pop(state, 1);
  return parameter;
}

void DeclaredParameters::declare(ParameterSet& owner, const DeclaredParameter& parameter,
                                 bool vectors) {
  const auto& [name, initial, min, max, doc] = parameter;
  const auto add = [&]<typename T>(const ParameterOptions& options) {
    try {
      own_.push_back(std::make_unique<Parameter<T>>(&owner, parameter.name, options));
    } catch (const std::logic_error& error) {
      throw std::invalid_argument(error.what());
    }
  };
  const auto quantity = as_quantity(initial);
  const auto vector = vectors ? unit_of_vector(initial) : std::nullopt;
  if (quantity || vector) {
    const std::string unit = quantity ? si_symbol(quantity->unit.dimension) : *vector;
    const std::string written = text_of(initial);
    const ParameterOptions options{
        .unit = unit, .initial = written, .min = min, .max = max, .doc = doc, .live = true};
    if (quantity)
      add.operator()<double>(options);
    else
      add.operator()<Vector3>(options);
  } else if (initial.as<bool>() != nullptr) {
    add.operator()<bool>({.initial = initial.text(), .doc = doc});
  } else if (initial.as<std::string>() != nullptr) {
    add.operator()<std::string>({.initial = *initial.as<std::string>(), .doc = doc});
  } else {
    add.operator()<Literal>({.doc = doc});
    if (initial.as<std::monostate>() == nullptr) own_.back()->set(initial);
  }
}

}  // namespace trocar::lua
