// SPDX-License-Identifier: Apache-2.0
#include "components/signal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace trocar {
namespace {

bool has_rotation(const TypeInfo& type) {
  if (&type == &type_info<Rotation>()) return true;
  for (const TypeField& field : type.fields)
    if (has_rotation(*field.type)) return true;
  return false;
}

Signature with_dimensions(Signature signature, const auto& dimension_of) {
  for (Unit& unit : signature.units) unit = si_unit(dimension_of(unit.dimension));
  return signature;
}

std::string needed(const Unit& unit) {
  return unit.dimension.dimensionless()
             ? std::string("a number without a unit")
             : fmt::format("a quantity in {0}, e.g. \"1 {0}\"", si_symbol(unit.dimension));
}

double read_number(const Literal& literal, const Unit& unit, const std::string& what) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("{} = {}: {}", what, literal.text(), why));
  };
  Quantity quantity;
  if (const auto* number = literal.as<double>())
    quantity.value = *number;
  else if (const auto* text = literal.as<std::string>())
    try {
      quantity = parse_quantity(*text);
    } catch (const UnitError& error) {
      refuse(error.what());
    }
  else
    refuse("needs " + needed(unit));
  const bool bare_zero = quantity.value == 0.0 && quantity.unit.dimension.dimensionless();
  if (!bare_zero && quantity.unit.dimension != unit.dimension) refuse("needs " + needed(unit));
  if (!std::isfinite(quantity.value)) refuse("needs a finite number");
  return quantity.value;
}

std::optional<Unit> unit_of(const Literal& literal) {
  const auto* text = literal.as<std::string>();
  if (text == nullptr) return std::nullopt;
  try {
    return parse_quantity(*text).unit;
  } catch (const UnitError&) {
    return std::nullopt;  // read_numbers() says what is wrong with it
  }
}

}  // namespace

Unit si_unit(const Dimension& dimension) {
  return {si_symbol(dimension), dimension, 1.0};
}

Signature real_signal(const Unit& unit) {
  return {&type_info<double>(), 0, {si_unit(unit.dimension)}, ""};
}

std::vector<Unit> number_units(const Signature& signature) {
  if (signature.type->fields.empty()) return {signature.units.front()};
  std::vector<Unit> units;
  for (std::size_t i = 0; i < field_count(*signature.type, signature.axes); ++i)
    for (const Unit& unit :
         number_units(select_field(signature, signature.type->fields[i].name).signature))
      units.push_back(unit);
  return units;
}

Signature multiplied(const Signature& signature, const Dimension& factor) {
  return with_dimensions(signature, [&](const Dimension& own) { return own * factor; });
}

Signature divided(const Signature& signature, const Dimension& divisor) {
  return with_dimensions(signature, [&](const Dimension& own) { return own / divisor; });
}

void require_linear(const Port& port) {
  if (port.signature() && has_rotation(*port.signature()->type))
    throw std::invalid_argument(
        fmt::format("{} is a {}: the numbers of a rotation cannot be added or scaled; take a "
                    "field, e.g. .position",
                    port.name(), port.signature()->type->name));
}

std::vector<double> read_numbers(const Literal& literal, const Signature& signature,
                                 const std::string& what) {
  const std::vector<Unit> units = number_units(signature);
  if (units.size() == 1) return {read_number(literal, units.front(), what)};
  const auto* list = literal.as<Literal::List>();
  if (list == nullptr || list->size() != units.size())
    throw std::invalid_argument(fmt::format("{} = {}: needs a list of {} values for a {}", what,
                                            literal.text(), units.size(), signature.text()));
  std::vector<double> numbers;
  for (std::size_t i = 0; i < units.size(); ++i)
    numbers.push_back(read_number((*list)[i], units[i], what));
  return numbers;
}

std::optional<Signature> natural_signature_of(const Literal& literal) {
  const auto* list = literal.as<Literal::List>();
  if (list == nullptr) return real_signal(unit_of(literal).value_or(Unit{}));
  if (list->size() != 3) return std::nullopt;
  Unit unit;
  for (const Literal& part : *list)
    if (const auto own = unit_of(part); own && unit.dimension.dimensionless()) unit = *own;
  return Signature{&type_info<Vector3>(), 0, {si_unit(unit.dimension)}, ""};
}

}  // namespace trocar
