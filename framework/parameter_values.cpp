// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/parameter.hpp"
#include "framework/text.hpp"

namespace trocar {
namespace {

// For each type that a parameter can have: how it is read, printed and called.
using Self = const ParameterBase&;

/// A script may write three numbers as a list or by name.
std::string read_vector(const Literal& literal, std::span<const char* const> names,
                        const auto& read_one, std::span<double> values) {
  if (const auto* list = literal.as<Literal::List>()) {
    if (list->size() != values.size())
      return fmt::format("needs {} values, got {}", values.size(), list->size());
    for (std::size_t i = 0; i < values.size(); ++i)
      if (const std::string wrong = read_one((*list)[i], values[i]); !wrong.empty()) return wrong;
    return "";
  }
  const auto* table = literal.as<Literal::Table>();
  if (table == nullptr)
    return fmt::format("needs a list of {} values or a table with {}", values.size(),
                       fmt::join(names, ", "));
  for (const auto& [key, part] : *table) {
    const auto found = std::find(names.begin(), names.end(), key);
    if (found == names.end())
      return fmt::format("has no \"{}\"{}", key, suggestion(key, {names.begin(), names.end()}));
    double& value = values[static_cast<std::size_t>(found - names.begin())];
    if (const std::string wrong = read_one(part, value); !wrong.empty()) return wrong;
  }
  return "";
}

constexpr const char* xyz[] = {"x", "y", "z"};
constexpr const char* roll_pitch_yaw[] = {"roll", "pitch", "yaw"};

Eigen::Vector3d angles_of(const Rotation& rotation) {
  const Eigen::Matrix3d r = rotation.eigen().toRotationMatrix();
  return {std::atan2(r(2, 1), r(2, 2)), std::asin(std::clamp(-r(2, 0), -1.0, 1.0)),
          std::atan2(r(1, 0), r(0, 0))};
}

std::string read_value(Self self, const Literal& literal, double& value) {
  return self.read_number(literal, value);
}
std::string print_value(Self self, double value) {
  return format_quantity(value, self.shown_unit());
}
const char* name_of(double) {
  return "number";
}

std::string read_value(Self self, const Literal& literal, std::int64_t& value) {
  double number = 0.0;
  if (const std::string wrong = self.read_number(literal, number); !wrong.empty()) return wrong;
  if (std::round(number) != number || std::abs(number) > 9e15) return "needs a whole number";
  value = static_cast<std::int64_t>(number);
  return "";
}
std::string print_value(Self, std::int64_t value) {
  return fmt::format("{}", value);
}
const char* name_of(std::int64_t) {
  return "whole number";
}

std::string read_value(Self, const Literal& literal, bool& value) {
  const auto* flag = literal.as<bool>();
  if (flag == nullptr) return "needs true or false";
  value = *flag;
  return "";
}
std::string print_value(Self, bool value) {
  return value ? "true" : "false";
}
const char* name_of(bool) {
  return "true or false";
}

std::string read_value(Self, const Literal& literal, std::string& value) {
  const auto* text = literal.as<std::string>();
  if (text == nullptr) return "needs a string";
  value = *text;
  return "";
}
std::string print_value(Self, const std::string& value) {
  return "\"" + value + "\"";
}
const char* name_of(const std::string&) {
  return "string";
}

std::string read_value(Self self, const Literal& literal, Choice& value) {
  const std::vector<std::string>& choices = self.choices();
  const auto* text = literal.as<std::string>();
  const auto found =
      text == nullptr ? choices.end() : std::find(choices.begin(), choices.end(), *text);
  if (found == choices.end()) {
    const bool near = text != nullptr && !nearest(*text, choices).empty();
    return fmt::format("needs one of \"{}\"{}", join(choices, "\", \""),
                       near ? suggestion(*text, choices) : "");
  }
  value.index = static_cast<int>(found - choices.begin());
  return "";
}
std::string print_value(Self self, Choice value) {
  return "\"" + self.choices()[static_cast<std::size_t>(value.index)] + "\"";
}
const char* name_of(Choice) {
  return "choice";
}

std::string read_value(Self self, const Literal& literal, Vector3& value) {
  const auto one = [&](const Literal& part, double& number) {
    return self.read_number(part, number);
  };
  return read_vector(literal, xyz, one, {&value.x, 3});
}
std::string print_value(Self self, const Vector3& value) {
  return fmt::format("{{{}, {}, {}}}", format_quantity(value.x, self.shown_unit()),
                     format_quantity(value.y, self.shown_unit()),
                     format_quantity(value.z, self.shown_unit()));
}
const char* name_of(const Vector3&) {
  return "three numbers";
}

/// Roll about x, then pitch about y, then yaw about z, all about fixed axes.
std::string read_value(Self self, const Literal& literal, Rotation& value) {
  double angles[3] = {};
  const auto one = [&](const Literal& part, double& number) {
    return self.read_number(part, number);
  };
  if (const std::string wrong = read_vector(literal, roll_pitch_yaw, one, angles); !wrong.empty())
    return wrong;
  value = Rotation(Eigen::AngleAxisd(angles[2], Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(angles[1], Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(angles[0], Eigen::Vector3d::UnitX()));
  return "";
}
std::string print_value(Self, const Rotation& value) {
  const Unit deg = parse_unit("deg");
  const Eigen::Vector3d a = angles_of(value);
  return fmt::format("{{roll = \"{}\", pitch = \"{}\", yaw = \"{}\"}}", format_quantity(a.x(), deg),
                     format_quantity(a.y(), deg), format_quantity(a.z(), deg));
}
const char* name_of(const Rotation&) {
  return "rotation";
}

std::string read_value(Self self, const Literal& literal, Joints& value) {
  const auto* list = literal.as<Literal::List>();
  if (list == nullptr || list->size() > max_axes)
    return fmt::format("needs a list of up to {} numbers, one for each axis", max_axes);
  for (std::size_t i = 0; i < list->size(); ++i)
    if (const std::string wrong = self.read_number((*list)[i], value.axis[i]); !wrong.empty())
      return wrong;
  return "";
}
std::string print_value(Self, const Joints& value) {
  return fmt::format("{{{:.12g}}}", fmt::join(value.axis, ", "));
}
const char* name_of(const Joints&) {
  return "a number for each axis";
}

std::string read_value(Self, const Literal& literal, Quantity& value) {
  if (const auto* number = literal.as<double>()) {
    if (!std::isfinite(*number)) return "must be a finite number";
    value = {*number, {}};
    return "";
  }
  const auto* text = literal.as<std::string>();
  if (text == nullptr) return "needs a quantity, e.g. \"3 mm\"";
  try {
    value = parse_quantity(*text);
  } catch (const UnitError& error) {
    return error.what();
  }
  return "";
}
std::string print_value(Self, const Quantity& value) {
  return format_quantity(value.value, value.unit);
}
const char* name_of(const Quantity&) {
  return "number in any unit";
}

std::string read_value(Self, const Literal& literal, Literal& value) {
  value = literal;
  return "";
}
std::string print_value(Self, const Literal& value) {
  return value.text();
}
const char* name_of(const Literal&) {
  return "any value";
}

template <typename T>
std::span<double> numbers_of(T& value) RT_SAFE {
  if constexpr (std::is_same_v<T, double>) return {&value, 1};
  if constexpr (std::is_same_v<T, Vector3>) return {&value.x, 3};
  if constexpr (std::is_same_v<T, Joints>) return {value.axis, max_axes};
  if constexpr (std::is_same_v<T, Quantity>) return {&value.value, 1};
  return {};
}

}  // namespace

template <typename T>
std::string Parameter<T>::read(const Literal& literal, T& value) const {
  return read_value(*this, literal, value);
}

template <typename T>
std::string Parameter<T>::text() const {
  return print_value(*this, value_);
}

template <typename T>
std::string Parameter<T>::type_name() const {
  return name_of(value_);
}

template <typename T>
std::span<double> Parameter<T>::numbers() RT_SAFE {
  return numbers_of(value_);
}

template class Parameter<double>;
template class Parameter<std::int64_t>;
template class Parameter<bool>;
template class Parameter<std::string>;
template class Parameter<Choice>;
template class Parameter<Vector3>;
template class Parameter<Rotation>;
template class Parameter<Joints>;
template class Parameter<Quantity>;
template class Parameter<Literal>;

}  // namespace trocar
