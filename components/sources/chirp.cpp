// SPDX-License-Identifier: Apache-2.0
#include "components/sources/chirp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace trocar {

using std::numbers::pi;

double LinearSweep::frequency(double t) const RT_SAFE {
  if (!(t >= 0.0 && t < duration)) return 0.0;
  return from + (to - from) * t / duration;
}

double LinearSweep::at(double t) const RT_SAFE {
  if (!(t >= 0.0 && t < duration)) return 0.0;
  const double edge = std::min(t, duration - t);
  const double window = edge < taper ? 0.5 * (1.0 - std::cos(pi * edge / taper)) : 1.0;
  const double phase = 2.0 * pi * (from * t + (to - from) * t * t / (2.0 * duration));
  return amplitude * window * std::sin(phase);
}

void Chirp::configure(const Setup&) {
  require_own_unit();
  if (!(2.0 * *taper <= *duration))
    throw std::invalid_argument(fmt::format("taper = \"{}\": at most half the duration, {:.6g} s",
                                            taper.text(), 0.5 * *duration));
  sweep_ = {amplitude->value, *from, *to, *duration, *taper};
}

void Chirp::start() {
  write(0.0);
}

void Chirp::step(const Tick& tick) RT_SAFE {
  write(tick.time);
}

void Chirp::write(double t) RT_SAFE {
  value.values()[0] = sweep_.at(t);
  *frequency = sweep_.frequency(t);
}

}  // namespace trocar
