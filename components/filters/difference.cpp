// SPDX-License-Identifier: Apache-2.0
#include "components/filters/difference.hpp"

namespace trocar {

void Difference::configure(const Setup& setup) {
  filters_.resize(count());
  state_quality(0.5 * setup.period, setup.period);
}

}  // namespace trocar
