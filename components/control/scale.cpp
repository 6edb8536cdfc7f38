// SPDX-License-Identifier: Apache-2.0
#include "components/control/scale.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "components/signal.hpp"

namespace trocar {

void Scale::unify() {
  const Dimension& unit = factor->unit.dimension;
  if (input.signature() && !value.signature())
    value.set_signature(multiplied(*input.signature(), unit));
  else if (value.signature() && !input.signature())
    input.set_signature(divided(*value.signature(), unit));
}

void Scale::configure(const Setup&) {
  require_linear(input);
  if (!std::isfinite(factor->value))
    throw std::invalid_argument(
        fmt::format("factor = \"{}\": needs a finite number", factor.text()));
  count_ = number_units(*input.signature()).size();
  value.quality.delay = input.delay();
  value.quality.resolution.clear();
  for (std::size_t i = 0; i < count_; ++i)
    value.quality.resolution.push_back(std::abs(factor->value) * input.resolution(i));
}

void Scale::step(const Tick&) RT_SAFE {
  for (std::size_t i = 0; i < count_; ++i) value.values()[i] = factor->value * input.values()[i];
}

}  // namespace trocar
