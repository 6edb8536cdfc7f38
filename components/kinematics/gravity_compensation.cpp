// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/gravity_compensation.hpp"

namespace trocar {

void GravityCompensation::configure(const Setup&) {
  model_.emplace(geometry.value());
  weight_.emplace(geometry.value(), masses.value());
  gravity_ = mount.gravity();
  effort.quality.delay = position.delay();
}

void GravityCompensation::step(const Tick&) RT_SAFE {
  LaparoscopeConfiguration c;
  const AssemblyStatus status = model_->forward(position->head<6>(), c);
  if (status != AssemblyStatus::ok) return fail(describe(status));
  effort->head<6>() = weight_->effort(c, model_->rates(c), gravity_);
}

}  // namespace trocar
