// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_statics.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace trocar {

void LaparoscopeStatics::configure(const Setup&) {
  double delay = 0.0;
  for (const InputPort* input : inputs()) delay = std::max(delay, input->delay());
  effort.quality.delay = wrench.quality.delay = delay;
}

void LaparoscopeStatics::step(const Tick&) RT_SAFE {
  Eigen::Vector3d total = Eigen::Vector3d::Zero(), turning = Eigen::Vector3d::Zero();
  const auto add = [&](const Vector3& at, const Inputs<Vector3>& forces,
                       const Inputs<Vector3>& moments) {
    const Eigen::Vector3d f = sum(forces);
    total += f;
    turning += (at.eigen() - origin->eigen()).cross(f) + sum(moments);
  };
  add(*tip_at, tip_force, tip_moment);
  add(*incision_at, incision_force, incision_moment);
  add(*handle_at, handle_force, handle_moment);
  *wrench = {total, turning};
  effort->head<6>() = jacobian->head<6>().transpose() * wrench->eigen();
}

}  // namespace trocar
