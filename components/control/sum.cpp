// SPDX-License-Identifier: Apache-2.0
#include "components/control/sum.hpp"

#include <algorithm>

#include "components/signal.hpp"

namespace trocar {

void Sum::configure(const Setup&) {
  require_linear(value);
  count_ = number_units(*value.signature()).size();
  value.quality.delay = std::max(terms.delay(), minus.delay());
  value.quality.resolution.assign(count_, 0.0);
  for (const GenericInput* input : {&terms, &minus})
    for (std::size_t source = 0; source < input->count(); ++source)
      for (std::size_t i = 0; i < count_; ++i)
        value.quality.resolution[i] += input->resolution(i, source);
}

void Sum::step(const Tick&) RT_SAFE {
  for (std::size_t i = 0; i < count_; ++i) {
    double total = 0.0;
    for (std::size_t source = 0; source < terms.count(); ++source) total += terms.values(source)[i];
    for (std::size_t source = 0; source < minus.count(); ++source) total -= minus.values(source)[i];
    value.values()[i] = total;
  }
}

}  // namespace trocar
