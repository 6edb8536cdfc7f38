// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"

namespace trocar {

/// value = Σ terms - Σ minus, number by number, all of one type and unit, in the order of the
/// wiring. As late as its latest term; a count of each may come at once, so their steps add.
class Sum final : public Component {
 public:
  /// @throw std::invalid_argument for rotations.
  void configure(const Setup& setup) override;
  void step(const Tick& tick) RT_SAFE override;

  GenericInput terms{this, "terms", {.doc = "what is added"}, true};
  GenericInput minus{this, "minus", {.doc = "what is taken off", .optional = true}, true};
  GenericOutput value{this, "value", {.doc = "the sum"}};

 private:
  std::size_t count_ = 0;
};

}  // namespace trocar
