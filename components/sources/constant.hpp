// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"

namespace trocar {

/// A value that stays. Its type, unit and frame are those of what it is wired to; by itself a
/// number is dimensionless, a quantity has its unit, and a list of three is a Vector3.
class Constant final : public Component {
 public:
  std::optional<Signature> natural_signature() const override;
  /// @throw std::invalid_argument when the value is not what it is wired to.
  void configure(const Setup& setup) override;
  void start() override;
  void step(const Tick& tick) RT_SAFE override;

  GenericOutput output{this, "value", {.doc = "the parameter `value`"}};
  Parameter<Literal> value{
      this, "value", {.doc = "a number, a quantity, or a list with one for each number"}};

 private:
  std::vector<double> numbers_;
};

}  // namespace trocar
