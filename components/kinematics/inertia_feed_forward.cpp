// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/inertia_feed_forward.hpp"

namespace trocar {

void InertiaFeedForward::configure(const Setup&) {
  dynamics_.emplace(geometry.value(), masses.value());
}

void InertiaFeedForward::step(const Tick&) RT_SAFE {
  LaparoscopeConfiguration c;
  const AssemblyStatus status = dynamics_->model().forward(position->head<6>(), c);
  if (status != AssemblyStatus::ok) return fail(describe(status));
  const LaparoscopeRates rates = dynamics_->model().rates(c);
  const auto inertia = dynamics_->inertia(c, rates);
  const auto bias = dynamics_->bias(c, rates, inertia, velocity->head<6>());
  effort->head<6>() = *share * (inertia.mass * acceleration->head<6>() + bias.effort);
}

}  // namespace trocar
