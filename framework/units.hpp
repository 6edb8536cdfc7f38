// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace trocar {

/// Exponents of the base quantities. The angle counts as one, so that an angle is never taken
/// for a number and a rotational stiffness never for a moment.
struct Dimension {
  enum Base : std::size_t { metre, kilogram, second, ampere, kelvin, radian, count };
  std::array<std::int8_t, count> exponent{};

  bool operator==(const Dimension&) const = default;
  bool dimensionless() const { return *this == Dimension{}; }
  Dimension operator*(const Dimension& other) const;
  Dimension operator/(const Dimension& other) const;
};

/// A unit as somebody wrote it: 1 `symbol` = `scale` in SI.
struct Unit {
  std::string symbol;  // "N/mm"; empty where dimensionless
  Dimension dimension;
  double scale = 1.0;
};

/// A number with its unit. `value` is in SI whatever the unit was.
struct Quantity {
  double value = 0.0;
  Unit unit;
};

/// Thrown by the parsers; what() says what was read, and what would be right.
struct UnitError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Reads "N/mm", "N s/m", "kg m^2", "J/(kg K)", "deg", "%" or "". A factor may carry a prefix
/// (µ or u, m, c, d, k, M) and an exponent. After a slash only one factor or a parenthesis counts;
/// "N/m s" is refused as ambiguous.
/// @throw UnitError on anything else.
Unit parse_unit(std::string_view text);

/// Reads "2.2 N/mm", "60 mm", "1 kHz", "-3e-2", "inf N".
/// @throw UnitError when there is no number, or what follows it is no unit.
Quantity parse_quantity(std::string_view text);

/// The number in `unit` and its symbol: 2200 and N/mm give "2.2 N/mm". Shortest text that reads
/// back as the same number to 12 digits.
std::string format_quantity(double value, const Unit& unit);

/// The SI symbol of a dimension, with the derived units of mechanics where they fit: "N/m",
/// "N m/rad", "rad/s".
std::string si_symbol(const Dimension& dimension);

}  // namespace trocar
