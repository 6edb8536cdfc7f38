// SPDX-License-Identifier: Apache-2.0
#include "components/filters/velocity_filter.hpp"

#include "components/signal.hpp"

namespace trocar {
namespace {

const Dimension& second() {
  static const Dimension dimension = parse_unit("s").dimension;
  return dimension;
}

}  // namespace

void VelocityFilter::unify() {
  if (position.signature() && !velocity.signature())
    velocity.set_signature(divided(*position.signature(), second()));
  else if (velocity.signature() && !position.signature())
    position.set_signature(multiplied(*velocity.signature(), second()));
}

std::size_t VelocityFilter::count() const {
  require_linear(position);
  return number_units(*position.signature()).size();
}

void VelocityFilter::state_quality(double late, double span) {
  count_ = count();
  velocity.quality.delay = position.delay() + late;
  velocity.quality.resolution.clear();
  for (std::size_t i = 0; i < count_; ++i)
    velocity.quality.resolution.push_back(position.resolution(i) / span);
}

void VelocityFilter::step(const Tick& tick) RT_SAFE {
  const double* now = position.values();
  for (std::size_t i = 0; i < count_; ++i) {
    if (!started_) reset(i, now[i]);
    velocity.values()[i] = started_ ? update(i, now[i], tick.dt) : 0.0;
  }
  started_ = true;
}

}  // namespace trocar
