// SPDX-License-Identifier: Apache-2.0
#include "components/control/product.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "components/signal.hpp"

namespace trocar {

void Product::unify() {
  if (!factor.signature()) return;
  const Dimension& unit = factor.signature()->units.front().dimension;
  if (input.signature() && !value.signature())
    value.set_signature(multiplied(*input.signature(), unit));
  else if (value.signature() && !input.signature())
    input.set_signature(divided(*value.signature(), unit));
}

void Product::configure(const Setup&) {
  if (factor.signature()->type != &type_info<double>())
    throw std::invalid_argument(
        fmt::format("factor is a {}: needs a single number; wire the other "
                    "one here, or take a field",
                    factor.signature()->text()));
  require_linear(input);
  count_ = number_units(*input.signature()).size();
  value.quality.delay = std::max(factor.delay(), input.delay());
  value.quality.resolution.clear();
  for (std::size_t i = 0; i < count_; ++i) value.quality.resolution.push_back(input.resolution(i));
}

void Product::step(const Tick&) RT_SAFE {
  for (std::size_t i = 0; i < count_; ++i) value.values()[i] = *factor.values() * input.values()[i];
}

}  // namespace trocar
