// SPDX-License-Identifier: Apache-2.0
#include "framework/gate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace trocar {
namespace {

constexpr double hold_ramp_time = 1.0;    // [s]
constexpr double effort_ramp_time = 0.5;  // [s]
constexpr double calm_time = 0.5;         // [s] before engaging
constexpr double calm_speed = 0.020;      // [m/s] of the handle
constexpr double sound_time = 0.1;        // [s] without a fault before one can be acknowledged
constexpr double deadline_periods = 3.0;  // after which a command is not valid any more
constexpr double ask_time = 0.025;        // [s] that a device is asked to clear its fault, and not

}  // namespace

Gate::Gate(Device& device, double period, FaultLatch& faults)
    : device_(device),
      limits_(device.limits()),
      period_(period),
      faults_(faults),
      state_(device.starts_engaged() ? State::engaged : State::cold),
      hold_ramp_(device.starts_engaged() ? 1.0 : 0.0),
      effort_ramp_(device.starts_engaged() ? 1.0 : 0.0) {
  if (device.has_gate_)
    throw std::logic_error("the device " + device.name() + " has a gate already");
  device.has_gate_ = true;
}

bool Gate::finite(const Joints& joints) RT_SAFE {
  double sum = 0.0;
  for (const double value : joints.axis) sum += value * 0.0;
  return sum == 0.0;
}

void Gate::pass(const Tick& tick, bool effort_usable, bool hold_usable) RT_SAFE {
  tick_ = tick;
  sound_for_ += period_;
  effort_lost_ = effort_lost_ || !effort_usable;
  hold_lost_ = hold_lost_ || !hold_usable;
  if (!effort_usable || !hold_usable) sound_for_ = 0.0;
  const DeviceStatus status = device_.status();
  watch_device(status);
  watch_position(status);
  watch_hold();
  watch_effort();
  advance_state(status);
  Joints sent = command();
  if (!finite(sent)) {
    trip(FaultCause::not_finite, "gated effort", 0.0, 0.0);
    position_lost_ = true;
    sent = rendered_before_ = {};
    **device_.scale_ = 0.0;
  }
  **device_.effort_sent_ = sent;
  GatedEffort gated(sent, tick.index,
                    tick.time_ns + static_cast<std::int64_t>(deadline_periods * period_ * 1e9));
  for (int i = 0; i < limits_.axes; ++i) gated.hold_[i] = sent[i] - rendered_before_[i];
  gated.mode_ = mode();
  // On and off again: what the device refuses a moment too early it is asked anew.
  gated.acknowledges_ =
      clearing_for_ >= 0.0 && (static_cast<int>(clearing_for_ / ask_time) & 1) == 0;
  device_.write(tick, gated);
}

DeviceMode Gate::mode() const RT_SAFE {
  if (home_requested_) return clearing_for_ >= 0.0 ? DeviceMode::off : DeviceMode::home;
  if (position_lost_ || hold_lost_ || !homed_) return DeviceMode::off;
  const bool renders = state_ == State::engaging || state_ == State::engaged ||
                       (state_ == State::holding && engage_requested_);
  return renders ? DeviceMode::render : DeviceMode::hold;
}

void Gate::stop_rendering(const Fault& fault) RT_SAFE {
  faults_.raise(fault);
  effort_lost_ = true;
  home_requested_ = false;
  sound_for_ = 0.0;
}

bool Gate::acknowledge() RT_SAFE {
  if (state_ != State::tripped || sound_for_ < sound_time) return false;
  if (position_lost_ || hold_lost_) hold_ramp_ = 0.0;
  position_lost_ = hold_lost_ = effort_lost_ = false;
  effort_ramp_ = 0.0;
  calm_for_ = 0.0;
  engage_requested_ = false;
  state_ = State::cold;
  clear_device();
  return true;
}

const char* Gate::request_home() RT_SAFE {
  const DeviceStatus status = device_.status();
  if (!status.position_valid) return "no report of the device is valid";
  if (status.homed) return "it is homed already";
  home_requested_ = true;
  clear_device();
  return nullptr;
}

void Gate::clear_device() RT_SAFE {
  if (device_fault_ == nullptr) return;
  device_fault_ = nullptr;
  clearing_for_ = 0.0;
}

void Gate::trip(FaultCause cause, const char* detail, double value, double limit) RT_SAFE {
  sound_for_ = 0.0;
  faults_.raise({.cause = cause,
                 .component = device_.name().c_str(),
                 .detail = detail,
                 .value = value,
                 .limit = limit,
                 .tick = tick_.index,
                 .time_ns = tick_.time_ns});
}

void Gate::advance_state(const DeviceStatus& status) RT_SAFE {
  const bool stopped_rendering = device_renders_ && !status.renders;
  device_renders_ = status.renders;
  if (position_lost_ || hold_lost_ || effort_lost_) {
    state_ = State::tripped;
    engage_requested_ = false;
    return;
  }
  switch (state_) {
    case State::tripped:
      break;
    case State::cold:
      if (!homed_ || clearing_for_ >= 0.0) break;
      hold_ramp_ = std::min(1.0, hold_ramp_ + period_ / hold_ramp_time);
      if (hold_ramp_ >= 1.0) state_ = State::holding;
      break;
    case State::holding: {
      bool calm = status.dead_man && device_.handle_speed(velocity()) < calm_speed;
      for (int i = 0; i < loads_.count; ++i) {
        const ToolLoad& load = loads_.load[static_cast<std::size_t>(i)];
        calm = calm && load.value.eigen().norm() < load.calm;
      }
      calm_for_ = calm ? calm_for_ + period_ : 0.0;
      if (stopped_rendering) engage_requested_ = false;
      if (engage_requested_ && calm_for_ >= calm_time && status.renders) state_ = State::engaging;
      break;
    }
    case State::engaging:
      effort_ramp_ = std::min(1.0, effort_ramp_ + period_ / effort_ramp_time);
      if (effort_ramp_ >= 1.0) state_ = State::engaged;
      [[fallthrough]];
    case State::engaged:
      if (status.dead_man && status.renders) break;
      state_ = State::holding;
      effort_ramp_ = calm_for_ = 0.0;
      engage_requested_ = false;
      break;
  }
}

double Gate::largest_scale() const RT_SAFE {
  const Joints& hold = **device_.hold_;
  const Joints& effort = **device_.effort_;
  double scale = effort_ramp_;
  for (int i = 0; i < limits_.axes; ++i) {
    const double room =
        limits_.effort[i] - std::copysign(hold_ramp_ * hold[i], effort[i] * hold[i]);
    if (std::abs(effort[i]) * scale > room) scale = room / std::abs(effort[i]);
  }
  for (int i = 0; i < loads_.count; ++i) {
    const ToolLoad& load = loads_.load[static_cast<std::size_t>(i)];
    const double size = load.value.eigen().norm();
    if (size * scale > load.cap) scale = load.cap / size;
  }
  return std::max(0.0, scale);
}

double Gate::risen_scale(double scale) const RT_SAFE {
  const Joints& effort = **device_.effort_;
  for (int i = 0; i < limits_.axes; ++i) {
    const bool same_sign = effort[i] * rendered_before_[i] > 0.0;
    const double reachable =
        (same_sign ? std::abs(rendered_before_[i]) : 0.0) + limits_.rise[i] * period_;
    if (std::abs(effort[i]) * scale > reachable) scale = reachable / std::abs(effort[i]);
  }
  return scale;
}

Joints Gate::command() RT_SAFE {
  Joints sent{};
  double scale = 0.0;
  if (position_lost_ || hold_lost_ || !homed_) {
    rendered_before_ = {};
    **device_.scale_ = 0.0;
    return sent;
  }
  const bool rendering = state_ == State::engaging || state_ == State::engaged;
  if (rendering) scale = risen_scale(largest_scale());
  for (int i = 0; i < limits_.axes; ++i) {
    rendered_before_[i] = rendering ? scale * (**device_.effort_)[i] : 0.0;
    sent[i] = hold_ramp_ * (**device_.hold_)[i];
    sent[i] += rendering ? rendered_before_[i] : damping(i);
    sent[i] = std::clamp(sent[i], -limits_.effort[i], limits_.effort[i]);
  }
  **device_.scale_ = scale;
  return sent;
}

double Gate::damping(int axis) const RT_SAFE {
  return std::clamp(-limits_.damping[axis] * velocity()[axis], -limits_.damping_cap[axis],
                    limits_.damping_cap[axis]);
}

const char* to_string(Gate::State state) RT_SAFE {
  switch (state) {
    case Gate::State::cold:
      return "cold";
    case Gate::State::holding:
      return "holding";
    case Gate::State::engaging:
      return "engaging";
    case Gate::State::engaged:
      return "engaged";
    case Gate::State::tripped:
      return "tripped";
  }
  return "unknown";
}

}  // namespace trocar
