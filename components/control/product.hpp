// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"

namespace trocar {

/// value = factor input, number by number; its unit is the product of both. How large the step of
/// one count becomes depends on the values as they run, so the resolution is that of a factor of
/// 1 in SI.
class Product final : public Component {
 public:
  void unify() override;
  /// @throw std::invalid_argument when the factor is no single number, and for rotations.
  void configure(const Setup& setup) override;
  void step(const Tick& tick) RT_SAFE override;

  GenericInput factor{this, "factor", {.doc = "a single number"}};
  GenericInput input{this, "input", {.doc = "what is multiplied by it"}};
  GenericOutput value{this, "value", {.doc = "factor × input"}};

 private:
  std::size_t count_ = 0;
};

}  // namespace trocar
