// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/tool_reference.hpp"

#include <Eigen/LU>

namespace trocar {

void ToolReference::configure(const Setup&) {
  dynamics_.emplace(geometry.value(), LaparoscopeMasses{});
}

void ToolReference::step(const Tick&) RT_SAFE {
  const LaparoscopeModel& model = dynamics_->model();
  LaparoscopeConfiguration c;
  if (!started_) {
    const AssemblyStatus status = model.forward(position->head<6>(), c);
    if (status != AssemblyStatus::ok) return fail(describe(status));
    begin_ = c.tool.pose();
    started_ = true;
  }
  PoseCoordinates goal = begin_;
  goal.tip += offset->eigen();
  Vector6d q;
  AssemblyStatus status = model.inverse(goal, q);
  if (status == AssemblyStatus::ok) status = model.forward(q, c);
  if (status != AssemblyStatus::ok) return fail(describe(status));

  const LaparoscopeRates rates = model.rates(c);
  const Eigen::PartialPivLU<Matrix6d> jacobian(rates.jacobian);
  Vector6d twist = Vector6d::Zero();
  twist.head<3>() = tip_velocity->eigen();
  const Vector6d speed = jacobian.solve(twist);
  const auto bias = dynamics_->bias(c, rates, dynamics_->inertia(c, rates), speed);
  Vector6d wanted;
  wanted.head<3>() = tip_acceleration->eigen() - bias.tip;
  wanted.tail<3>() = -bias.angular;
  axes->head<6>() = q;
  axes_velocity->head<6>() = speed;
  axes_acceleration->head<6>() = jacobian.solve(wanted);
}

}  // namespace trocar
