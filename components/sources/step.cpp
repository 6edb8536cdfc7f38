// SPDX-License-Identifier: Apache-2.0
#include "components/sources/step.hpp"

#include <cmath>

namespace trocar {

/// A step down to a bare zero has the unit of where it comes from.
const Parameter<Quantity>& Step::scale() const {
  const bool bare_zero = to->value == 0.0 && to->unit.dimension.dimensionless();
  return bare_zero ? from : to;
}

void Step::configure(const Setup&) {
  require_own_unit();
  before_ = in_own_unit(from);
  after_ = in_own_unit(to);
  at_ns_ = std::llround(*at * 1e9);
}

void Step::step(const Tick& tick) RT_SAFE {
  value.values()[0] = tick.time_ns < at_ns_ ? before_ : after_;
}

}  // namespace trocar
