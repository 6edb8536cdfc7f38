// SPDX-License-Identifier: Apache-2.0
#include "framework/units.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace trocar {
namespace {

constexpr Dimension dim(int m, int kg, int s, int ampere = 0, int kelvin = 0, int rad = 0) {
  const auto e = [](int exponent) { return static_cast<std::int8_t>(exponent); };
  return {{e(m), e(kg), e(s), e(ampere), e(kelvin), e(rad)}};
}

struct Symbol {
  std::string_view name;
  double scale;
  Dimension dimension;
  bool takes_prefix;
};

constexpr double pi = std::numbers::pi;
constexpr std::array symbols = {
    Symbol{"m", 1.0, dim(1, 0, 0), true},
    Symbol{"g", 1e-3, dim(0, 1, 0), true},
    Symbol{"s", 1.0, dim(0, 0, 1), true},
    Symbol{"A", 1.0, dim(0, 0, 0, 1), true},
    Symbol{"K", 1.0, dim(0, 0, 0, 0, 1), false},
    Symbol{"rad", 1.0, dim(0, 0, 0, 0, 0, 1), true},
    Symbol{"deg", pi / 180.0, dim(0, 0, 0, 0, 0, 1), false},
    Symbol{"°", pi / 180.0, dim(0, 0, 0, 0, 0, 1), false},
    Symbol{"rev", 2.0 * pi, dim(0, 0, 0, 0, 0, 1), false},
    Symbol{"N", 1.0, dim(1, 1, -2), true},
    Symbol{"Pa", 1.0, dim(-1, 1, -2), true},
    Symbol{"J", 1.0, dim(2, 1, -2), true},
    Symbol{"W", 1.0, dim(2, 1, -3), true},
    Symbol{"V", 1.0, dim(2, 1, -3, -1), true},
    Symbol{"Hz", 1.0, dim(0, 0, -1), true},
    Symbol{"min", 60.0, dim(0, 0, 1), false},
    Symbol{"h", 3600.0, dim(0, 0, 1), false},
    Symbol{"%", 1e-2, Dimension{}, false},
};

struct Prefix {
  std::string_view name;
  double scale;
};
constexpr std::array prefixes = {Prefix{"µ", 1e-6}, Prefix{"u", 1e-6}, Prefix{"m", 1e-3},
                                 Prefix{"c", 1e-2}, Prefix{"d", 1e-1}, Prefix{"k", 1e3},
                                 Prefix{"M", 1e6}};

std::optional<Symbol> find_symbol(std::string_view name) {
  for (const Symbol& symbol : symbols)
    if (symbol.name == name) return symbol;
  for (const Prefix& prefix : prefixes) {
    if (!name.starts_with(prefix.name)) continue;
    const std::string_view rest = name.substr(prefix.name.size());
    for (const Symbol& symbol : symbols)
      if (symbol.takes_prefix && symbol.name == rest)
        return Symbol{name, symbol.scale * prefix.scale, symbol.dimension, false};
  }
  return std::nullopt;
}

Dimension power(const Dimension& base, int exponent) {
  Dimension result;
  for (std::size_t i = 0; i < Dimension::count; ++i)
    result.exponent[i] = static_cast<std::int8_t>(base.exponent[i] * exponent);
  return result;
}

/// Recursive descent over a unit's text: expression = factor { (space|*|·|/) factor }.
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : whole_(text), rest_(text) {}

  Unit parse() {
    Unit unit = expression();
    if (!rest_.empty()) refuse(fmt::format("cannot read \"{}\"", rest_));
    unit.symbol = std::string(whole_);
    return unit;
  }

 private:
  Unit expression() {
    Unit product;
    bool divided = false;
    if (++depth_ > 8) refuse("parentheses are nested too deep");
    skip_spaces();
    if (rest_.starts_with('*') || rest_.starts_with("·")) refuse("a unit is missing");
    while (!rest_.empty() && rest_.front() != ')') {
      const bool divide = take_separator();
      if (!divide && divided)
        refuse("a product after a slash is ambiguous, write N/(m s) or N s/m");
      const Unit factor = this->factor();
      product.scale = divide ? product.scale / factor.scale : product.scale * factor.scale;
      product.dimension =
          divide ? product.dimension / factor.dimension : product.dimension * factor.dimension;
      for (const std::int8_t exponent : product.dimension.exponent)
        if (std::abs(exponent) > 12) refuse("a power beyond 12 is no unit of anything");
      if (!(product.scale >= 1e-100 && product.scale <= 1e100)) refuse("too large or too small");
      divided = divided || divide;
      skip_spaces();
    }
    --depth_;
    return product;
  }

  bool take_separator() {
    if (rest_.starts_with("·")) rest_.remove_prefix(std::string_view("·").size());
    const bool divide = rest_.starts_with('/');
    if (divide || rest_.starts_with('*')) rest_.remove_prefix(1);
    skip_spaces();
    return divide;
  }

  Unit factor() {
    if (rest_.starts_with('(')) {
      rest_.remove_prefix(1);
      Unit inner = expression();
      if (!rest_.starts_with(')')) refuse("a \")\" is missing");
      rest_.remove_prefix(1);
      return inner;
    }
    if (rest_.starts_with("1")) {  // "1/s"
      rest_.remove_prefix(1);
      return {};
    }
    const std::string_view name = take_name();
    const auto symbol = find_symbol(name);
    if (!symbol) refuse(fmt::format("\"{}\" is no unit{}", name, hint(name)));
    const int exponent = take_exponent();
    return {"", power(symbol->dimension, exponent), std::pow(symbol->scale, exponent)};
  }

  static std::string hint(std::string_view name) {
    for (std::size_t cut = 1; cut < name.size(); ++cut)
      if (find_symbol(name.substr(0, cut)) && find_symbol(name.substr(cut)))
        return fmt::format(", write \"{} {}\"", name.substr(0, cut), name.substr(cut));
    return ", known are m g s A K rad deg rev N Pa J W V Hz min h % with the prefixes µ m c d k M";
  }

  std::string_view take_name() {
    std::size_t n = 0;
    while (n < rest_.size()) {
      const unsigned char c = static_cast<unsigned char>(rest_[n]);
      if (rest_.substr(n).starts_with("·") || rest_.substr(n).starts_with("²")) break;
      if (std::isalpha(c) || c == '%' || c >= 0x80)
        ++n;
      else
        break;
    }
    if (n == 0)
      refuse(rest_.empty() ? "a unit is missing" : fmt::format("cannot read \"{}\"", rest_));
    const std::string_view name = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return name;
  }

  int take_exponent() {
    if (rest_.starts_with("²")) {
      rest_.remove_prefix(std::string_view("²").size());
      return 2;
    }
    const bool caret = rest_.starts_with('^');
    if (caret) rest_.remove_prefix(1);
    int exponent = 1;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), exponent);
    if (error == std::errc::invalid_argument && !caret) return 1;
    if (error != std::errc{} || exponent == 0 || std::abs(exponent) > 4)
      refuse("an exponent must be within -4 to 4, not 0");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return exponent;
  }

  void skip_spaces() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw UnitError(fmt::format("\"{}\": {}", whole_, why));
  }

  std::string_view whole_;
  std::string_view rest_;
  int depth_ = 0;
};

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

}  // namespace

Dimension Dimension::operator*(const Dimension& other) const {
  Dimension product;
  for (std::size_t i = 0; i < count; ++i)
    product.exponent[i] = static_cast<std::int8_t>(exponent[i] + other.exponent[i]);
  return product;
}

Dimension Dimension::operator/(const Dimension& other) const {
  return *this * power(other, -1);
}

Unit parse_unit(std::string_view text) {
  return UnitParser(trimmed(text)).parse();
}

Quantity parse_quantity(std::string_view text) {
  std::string_view rest = trimmed(text);
  if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error == std::errc::result_out_of_range)
    throw UnitError(fmt::format("\"{}\": the number is too large or too small", text));
  if (error != std::errc{} || std::isnan(number))
    throw UnitError(fmt::format("\"{}\" is no quantity, a number and a unit are needed", text));
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  try {
    Unit unit = parse_unit(rest);
    // Division where it is exact keeps 2.2 N/mm at the double nearest to 2200.
    const double inverse = std::round(1.0 / unit.scale);
    const bool exact = unit.scale < 1.0 && std::abs(inverse * unit.scale - 1.0) < 1e-15;
    return {exact ? number / inverse : number * unit.scale, std::move(unit)};
  } catch (const UnitError& error_in_unit) {
    throw UnitError(fmt::format("\"{}\": {}", text, error_in_unit.what()));
  }
}

std::string format_quantity(double value, const Unit& unit) {
  const std::string number = fmt::format("{:.12g}", value / unit.scale + 0.0);  // no "-0"
  return unit.symbol.empty() ? number : number + " " + unit.symbol;
}

std::string si_symbol(const Dimension& dimension) {
  static constexpr std::array derived = {
      "",    "m",     "s",       "kg",        "rad", "N",     "N m",   "J",       "W",
      "Hz",  "A",     "K",       "V",         "m/s", "m/s^2", "rad/s", "rad/s^2", "N/m",
      "m/N", "N s/m", "N m/rad", "N m s/rad", "N/s", "Pa",    "N m/s", "kg m^2"};
  for (const char* symbol : derived)
    if (parse_unit(symbol).dimension == dimension) return symbol;
  static constexpr std::array names = {"m", "kg", "s", "A", "K", "rad"};
  std::string above, below;
  for (std::size_t i = 0; i < Dimension::count; ++i) {
    const int e = dimension.exponent[i];
    if (e == 0) continue;
    std::string& side = e > 0 ? above : below;
    if (!side.empty()) side += ' ';
    side += names[i];
    if (std::abs(e) > 1) side += fmt::format("^{}", std::abs(e));
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" +
         ((below.find(" ") != std::string::npos) ? "(" + below + ")" : below);
}

}  // namespace trocar
