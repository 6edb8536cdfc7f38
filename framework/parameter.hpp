// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <any>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "framework/literal.hpp"
#include "framework/realtime/rt_safe.hpp"
#include "framework/types.hpp"
#include "framework/units.hpp"

namespace trocar {

class ParameterSet;

/// One of the choices that a parameter names.
struct Choice {
  int index = 0;
};

struct ParameterOptions {
  std::string_view unit = {};     // "N/m"; the value is in SI, errors and help print this unit
  std::string_view initial = {};  // as a script would write it; "" makes the parameter required
  std::string_view min = {};
  std::string_view max = {};
  std::string_view doc = {};
  bool live = false;  // may be edited while the graph runs, under a ramp
  std::vector<std::string> choices = {};
};

/// A declared setting of a component. Setting it checks unit and range and says what is wrong.
class ParameterBase {
 public:
  ParameterBase(const ParameterBase&) = delete;
  ParameterBase& operator=(const ParameterBase&) = delete;
  virtual ~ParameterBase() = default;

  const std::string& name() const { return name_; }
  const std::string& doc() const { return doc_; }
  const Unit& unit() const { return unit_; }
  /// In which values are shown: the range's own where there is one.
  const Unit& shown_unit() const { return shown_unit_; }
  const std::vector<std::string>& choices() const { return choices_; }
  bool live() const { return live_; }
  bool required() const { return !has_initial_; }
  bool assigned() const { return assigned_ || has_initial_; }
  std::string range_text() const;  // "0–50 N/mm", or "" without a range

  /// What is wrong with the value, or "" when it was taken.
  std::string set(const Literal& literal);
  /// The same checks without taking the value.
  virtual std::string check(const Literal& literal) const = 0;
  virtual void copy_from(const ParameterBase& other) = 0;
  /// The value and whether it was set, for restore().
  virtual std::any save() const = 0;
  virtual void restore(const std::any& value) = 0;
  /// The value as a script would write it.
  virtual std::string text() const = 0;
  virtual std::string type_name() const = 0;
  /// The numbers that a live edit may move; empty for parameters that are no numbers.
  virtual std::span<double> numbers() RT_SAFE { return {}; }

  /// Reads a number with this parameter's unit and range: a quantity in the right unit, a bare
  /// number where dimensionless or zero. What is wrong, or "".
  std::string read_number(const Literal& literal, double& value) const;

  /// Narrows the range for a reason that the component found when it was configured.
  void limit(double max, std::string reason);
  double min() const { return min_; }
  double max() const { return max_; }
  const std::string& limit_reason() const { return limit_reason_; }

 protected:
  ParameterBase(ParameterSet* owner, std::string_view name, const ParameterOptions& options);
  virtual std::string take(const Literal& literal) = 0;
  /// Called at the end of each constructor, when take() can be called.
  void take_initial(std::string_view initial);
  std::string check_range(double value) const;
  std::string check_unit(const Quantity& quantity, const std::string& written) const;
  std::string example(std::string_view number) const;

 private:
  std::string name_;
  std::string doc_;
  Unit unit_;
  Unit shown_unit_;  // of the range, as it was declared
  double min_;
  double max_;
  std::string limit_reason_;
  std::vector<std::string> choices_;
  bool live_;
  bool has_initial_;

 protected:
  bool assigned_ = false;  // by set(), beside any initial value
};

/// A parameter of type double, int64, bool, string, Choice, Vector3, Rotation, Joints, Quantity
/// (any unit) or Literal (any value). Numbers are in SI.
template <typename T>
class Parameter final : public ParameterBase {
 public:
  Parameter(ParameterSet* owner, std::string_view name, const ParameterOptions& options)
      : ParameterBase(owner, name, options) {
    take_initial(options.initial);
  }
  const T& operator*() const RT_SAFE { return value_; }
  const T* operator->() const RT_SAFE { return &value_; }

  std::string check(const Literal& literal) const override {
    T ignored = value_;
    return read(literal, ignored);
  }
  void copy_from(const ParameterBase& other) override {
    value_ = static_cast<const Parameter&>(other).value_;
  }
  std::any save() const override { return std::pair(value_, assigned_); }
  void restore(const std::any& saved) override {
    std::tie(value_, assigned_) = std::any_cast<std::pair<T, bool>>(saved);
  }
  std::string text() const override;
  std::string type_name() const override;
  std::span<double> numbers() RT_SAFE override;

 private:
  std::string take(const Literal& literal) override {
    T value = value_;
    std::string wrong = read(literal, value);
    if (wrong.empty()) value_ = value;
    return wrong;
  }
  std::string read(const Literal& literal, T& value) const;
  T value_{};
};

extern template class Parameter<double>;
extern template class Parameter<std::int64_t>;
extern template class Parameter<bool>;
extern template class Parameter<std::string>;
extern template class Parameter<Choice>;
extern template class Parameter<Vector3>;
extern template class Parameter<Rotation>;
extern template class Parameter<Joints>;
extern template class Parameter<Quantity>;
extern template class Parameter<Literal>;

}  // namespace trocar
