// SPDX-License-Identifier: Apache-2.0
#include "framework/parameter.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "framework/parameter_set.hpp"
#include "framework/text.hpp"

namespace trocar {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

ParameterBase::ParameterBase(ParameterSet* owner, std::string_view name,
                             const ParameterOptions& options)
    : name_(name),
      doc_(options.doc),
      unit_(parse_unit(options.unit)),
      min_(options.min.empty() ? -infinity : parse_quantity(options.min).value),
      max_(options.max.empty() ? infinity : parse_quantity(options.max).value),
      choices_(options.choices),
      live_(options.live),
      has_initial_(!options.initial.empty()) {
  shown_unit_ = options.max.empty() ? unit_ : parse_quantity(options.max).unit;
  for (const std::string_view bound : {options.min, options.max})
    if (!bound.empty() && parse_quantity(bound).value != 0.0 &&
        parse_quantity(bound).unit.dimension != unit_.dimension)
      throw std::logic_error(fmt::format("the range of {}: {} is not in {}", name, bound,
                                         unit_.symbol.empty() ? "plain numbers" : unit_.symbol));
  if (shown_unit_.dimension != unit_.dimension) shown_unit_ = unit_;  // a bare 0
  owner->add(this);
}

std::string ParameterBase::set(const Literal& literal) {
  std::string wrong = take(literal);
  if (wrong.empty()) assigned_ = true;
  return wrong;
}

void ParameterBase::take_initial(std::string_view initial) {
  if (!has_initial_) return;
  if (const std::string wrong = take(literal_from_text(initial)); !wrong.empty())
    throw std::logic_error(fmt::format("the initial value of {}: {}", name_, wrong));
}

void ParameterBase::limit(double max, std::string reason) {
  if (!(max < max_)) return;
  max_ = max;
  limit_reason_ = std::move(reason);
}

std::string ParameterBase::range_text() const {
  const auto number = [&](double v) { return fmt::format("{:.6g}", v / shown_unit_.scale); };
  const std::string unit = shown_unit_.symbol.empty() ? "" : " " + shown_unit_.symbol;
  if (min_ > -infinity && max_ < infinity)
    return number(min_) + (min_ < 0 ? " to " : "–") + number(max_) + unit;
  if (min_ > -infinity) return "at least " + number(min_) + unit;
  if (max_ < infinity) return "at most " + number(max_) + unit;
  return "";
}

std::string ParameterBase::check_range(double value) const {
  if (value >= min_ && value <= max_) return "";
  if (!std::isfinite(value)) return "must be a finite number";
  if (!limit_reason_.empty() && value > max_)
    return fmt::format("must be at most {}: {}", format_quantity(max_, shown_unit_), limit_reason_);
  const bool two_sided = min_ > -infinity && max_ < infinity;
  return fmt::format("must be {}{}", two_sided ? "within " : "", range_text());
}

/// The number that was written in the right unit, where that would be accepted.
std::string ParameterBase::example(std::string_view number) const {
  for (const std::string_view candidate : {number, std::string_view("1")}) {
    const std::string text = fmt::format("{} {}", candidate, shown_unit_.symbol);
    try {
      if (check_range(parse_quantity(text).value).empty()) return text;
    } catch (const UnitError&) {
    }
  }
  return format_quantity(min_ > -infinity ? min_ : max_, shown_unit_);
}

std::string ParameterBase::check_unit(const Quantity& quantity, const std::string& written) const {
  if (quantity.unit.dimension == unit_.dimension) return "";
  const std::string_view number =
      trim(std::string_view(written).substr(0, written.find_first_not_of("+-.0123456789eE")));
  const std::string range = range_text();
  if (unit_.dimension.dimensionless()) return "needs a number without a unit";
  return fmt::format("needs {}, e.g. \"{}\"{}", unit_.symbol, example(number),
                     range.empty() ? "" : " (" + range + ")");
}

std::string ParameterBase::read_number(const Literal& literal, double& value) const {
  Quantity quantity;
  std::string written = literal.text();
  if (const auto* number = literal.as<double>()) {
    quantity.value = *number;
    if (*number == 0.0) quantity.unit = unit_;
  } else if (const auto* text = literal.as<std::string>()) {
    written = *text;
    try {
      quantity = parse_quantity(*text);
    } catch (const UnitError& error) {
      return error.what();
    }
    if (quantity.value == 0.0 && quantity.unit.dimension.dimensionless()) quantity.unit = unit_;
  } else {
    return unit_.symbol.empty() ? std::string("needs a number")
                                : fmt::format("needs a quantity in {}", unit_.symbol);
  }
  if (const std::string wrong = check_unit(quantity, written); !wrong.empty()) return wrong;
  if (const std::string wrong = check_range(quantity.value); !wrong.empty()) return wrong;
  value = quantity.value;
  return "";
}

}  // namespace trocar
