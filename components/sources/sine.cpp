// SPDX-License-Identifier: Apache-2.0
#include "components/sources/sine.hpp"

#include <cmath>
#include <numbers>

namespace trocar {

double SineWave::at(double t) const RT_SAFE {
  return offset + amplitude * std::sin(2.0 * std::numbers::pi * frequency * t + phase);
}

void Sine::configure(const Setup&) {
  require_own_unit();
  wave_ = {amplitude->value, *frequency, *phase, in_own_unit(offset)};
}

void Sine::step(const Tick& tick) RT_SAFE {
  value.values()[0] = wave_.at(tick.time);
}

}  // namespace trocar
