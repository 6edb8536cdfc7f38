// SPDX-License-Identifier: Apache-2.0
#include "components/control/creep.hpp"

#include <cmath>

namespace trocar {

void Creep::step(const Tick& tick) RT_SAFE {
  const double in_the_end = *compliance * *load;
  *depth = in_the_end + (*depth - in_the_end) * std::exp(-tick.dt / *time_constant);
}

}  // namespace trocar
