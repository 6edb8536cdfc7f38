// SPDX-License-Identifier: Apache-2.0
#include "components/sources/constant.hpp"

#include <algorithm>

#include "components/signal.hpp"

namespace trocar {

std::optional<Signature> Constant::natural_signature() const {
  return natural_signature_of(*value);
}

void Constant::configure(const Setup&) {
  numbers_ = read_numbers(*value, *output.signature(), "value");
}

void Constant::start() {
  std::copy(numbers_.begin(), numbers_.end(), output.values().begin());
}

void Constant::step(const Tick&) RT_SAFE {}

}  // namespace trocar
