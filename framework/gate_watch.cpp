// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "framework/gate.hpp"

namespace trocar {
namespace {

constexpr double longest_gap = 0.05;   // [s] between two ticks while rendering goes on
constexpr double clearing_time = 0.2;  // [s] for a device to clear what it latched

}  // namespace

/// What it latched is history once tripped for: it neither trips again nor keeps anybody from
/// acknowledging, unless it stays after that.
void Gate::watch_device(const DeviceStatus& status) RT_SAFE {
  if (clearing_for_ >= 0.0) clearing_for_ += period_;
  if (status.fault == nullptr || clearing_for_ > clearing_time) clearing_for_ = -1.0;
  if (clearing_for_ >= 0.0) return;
  if (status.fault != nullptr) {
    effort_lost_ = true;
    hold_lost_ = hold_lost_ || !status.holds;
    if (status.fault != device_fault_) {
      trip(FaultCause::device_fault, status.fault, 0.0, 0.0);
      home_requested_ = false;
    }
  }
  device_fault_ = status.fault;
}

void Gate::watch_position(const DeviceStatus& status) RT_SAFE {
  const Joints& position = **device_.position_;
  if (!status.position_valid || !finite(position)) {
    trip(FaultCause::position_lost, status.position_valid ? "not finite" : status.why, 0.0, 0.0);
    position_lost_ = true;
    started_ = false;  // the next good report follows upon none
    home_requested_ = false;
    return;
  }
  homed_ = status.homed;
  if (!homed_) {
    if (state_ != State::cold) {
      trip(FaultCause::position_lost, *status.why != 0 ? status.why : "not homed", 0.0, 0.0);
      position_lost_ = true;
    }
    hold_ramp_ = 0.0;
    started_ = false;  // homing steps the position
    return;
  }
  home_requested_ = false;
  if (!started_) velocity_.reset(position, now(), period_);
  for (int i = 0; started_ && i < limits_.axes; ++i) {
    const double jump = std::abs(position[i] - position_before_[i]);
    const double possible = limits_.jump[i] * periods_since_report();
    if (jump <= possible) continue;
    trip(FaultCause::encoder_jump, "between two reports", jump, possible);
    position_lost_ = true;
  }
  const double gap = periods_since_report() * period_;
  if (started_ && gap > std::max(longest_gap, 2.0 * period_)) {
    trip(FaultCause::overload, "no tick for so long", gap, longest_gap);
    effort_lost_ = true;
  }
  started_ = true;
  position_before_ = position;
  reported_at_ = tick_.index;
  velocity_.update(position, now());
  watch_motion();
}

void Gate::watch_motion() RT_SAFE {
  const Joints& position = **device_.position_;
  const double handle_speed = device_.handle_speed(velocity());
  if (!(handle_speed <= limits_.handle_speed)) {
    trip(FaultCause::speed, "handle", handle_speed, limits_.handle_speed);
    effort_lost_ = true;
  }
  for (int i = 0; i < limits_.axes; ++i) {
    if (!(std::abs(velocity()[i]) <= limits_.speed[i])) {
      trip(FaultCause::speed, "axis", std::abs(velocity()[i]), limits_.speed[i]);
      effort_lost_ = true;
    }
    const double beyond =
        std::max(limits_.lowest[i] - position[i], position[i] - limits_.highest[i]);
    if (!(beyond <= limits_.margin[i])) {
      trip(FaultCause::workspace, "axis beyond its range", beyond, limits_.margin[i]);
      effort_lost_ = true;
    }
  }
}

/// A slot that was skipped leaves the device time to move.
double Gate::periods_since_report() const RT_SAFE {
  return static_cast<double>(std::max<std::int64_t>(1, tick_.index - reported_at_));
}

void Gate::watch_hold() RT_SAFE {
  const Joints& hold = **device_.hold_;
  if (!finite(hold)) {
    trip(FaultCause::not_finite, "hold", 0.0, 0.0);
    hold_lost_ = true;
    return;
  }
  for (int i = 0; i < limits_.axes; ++i) {
    if (std::abs(hold[i]) <= limits_.effort[i]) continue;
    trip(FaultCause::hold_beyond_limit, "hold", std::abs(hold[i]), limits_.effort[i]);
    hold_lost_ = true;
  }
  if (hold_lost_ || position_lost_ || !homed_ || !device_.hold_->connected()) return;
  const Joints weight = device_.weight();
  for (int i = 0; i < limits_.axes; ++i) {
    const double beyond = std::abs(hold[i] - weight[i]);
    if (beyond <= limits_.hold_tolerance[i]) continue;
    trip(FaultCause::hold_beyond_limit, "hold is not the device's weight", beyond,
         limits_.hold_tolerance[i]);
    hold_lost_ = true;
  }
}

void Gate::watch_effort() RT_SAFE {
  const Joints& effort = **device_.effort_;
  loads_.count = 0;
  if (!finite(effort)) {
    trip(FaultCause::not_finite, "effort", 0.0, 0.0);
    effort_lost_ = true;
    return;
  }
  if (!homed_) return;  // what is computed from no position yet loads nothing
  device_.tool_loads(effort, loads_);
  for (int i = 0; i < loads_.count; ++i) {
    const ToolLoad& load = loads_.load[static_cast<std::size_t>(i)];
    const double size = load.value.eigen().norm();
    if (size <= load.trip) continue;
    trip(FaultCause::handle_wrench, load.what, size, load.trip);
    effort_lost_ = true;
  }
}

}  // namespace trocar
