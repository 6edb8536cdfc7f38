// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"

namespace trocar {

/// value = factor input, number by number; its unit is the input's times the factor's.
class Scale final : public Component {
 public:
  void unify() override;
  /// @throw std::invalid_argument for rotations, and a factor that is not finite.
  void configure(const Setup& setup) override;
  void step(const Tick& tick) RT_SAFE override;

  GenericInput input{this, "input", {.doc = "what is scaled"}};
  GenericOutput value{this, "value", {.doc = "factor × input"}};
  Parameter<Quantity> factor{this, "factor", {.doc = "a number, or a quantity: \"2 N/mm\""}};

 private:
  std::size_t count_ = 0;
};

}  // namespace trocar
