// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/device_state_machine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace trocar::hid {
namespace {

const CommandReport off;

void count_up(std::uint32_t& time_us, std::uint32_t elapsed_us, std::uint32_t end_us) RT_SAFE {
  time_us = std::min(end_us, time_us + std::min(elapsed_us, end_us));
}

}  // namespace

DeviceStateMachine::DeviceStateMachine(const DeviceRules& rules)
    : rules_(rules), motion_(rules.speed) {}

const PerAxis<std::int16_t>& DeviceStateMachine::step(const DeviceInputs& in,
                                                      CommandIntake& intake) RT_SAFE {
  elapsed_us_ = started_ ? in.time_us - time_us_ : 0;
  time_us_ = in.time_us;
  started_ = true;
  motion_.update(in.encoder, elapsed_us_, state_ == DeviceState::homing ? in.found : 0);

  const bool alive = intake.watch(in.time_us);
  const CommandReport& command = alive ? intake.latest() : off;
  if (command.mode != spent_) spent_ = CommandMode::off;

  const bool went_on = alive && intake.silences() == silences_;
  silences_ = intake.silences();

  const DeviceFault wrong = wrong_now(in, went_on);
  if (wrong == DeviceFault::none)
    count_up(clear_us_, elapsed_us_, clear_us);
  else
    fail(wrong);
  if (!went_on) holds_ = holds_ && state_ != DeviceState::fault;

  acknowledge(command, command.acknowledge && !acknowledged_);
  advance(in, command);
  acknowledged_ = command.acknowledge;
  last_mode_ = command.mode;
  apply(in, command);
  return effort_;
}

DeviceFault DeviceStateMachine::wrong_now(const DeviceInputs& in, bool went_on) const RT_SAFE {
  const bool was_moved = last_mode_ != CommandMode::off && state_ != DeviceState::unhomed;
  if (state_ != DeviceState::unhomed && motion_.jumped()) return DeviceFault::encoder_jump;
  if (!went_on && was_moved) return DeviceFault::watchdog;
  if (*std::max_element(in.temperature.begin(), in.temperature.end()) > rules_.hottest)
    return DeviceFault::temperature;
  if (state_ == DeviceState::homing && motion_.faster_than(rules_.homing_speed))
    return DeviceFault::homing;
  if (state_ != DeviceState::unhomed && motion_.too_fast()) return DeviceFault::speed;
  return DeviceFault::none;
}

void DeviceStateMachine::fail(DeviceFault cause) RT_SAFE {
  clear_us_ = 0;
  if (cause == DeviceFault::encoder_jump || state_ == DeviceState::homing) homed_ = 0;
  if (state_ != DeviceState::fault) fault_ = cause;
  state_ = DeviceState::fault;
}

void DeviceStateMachine::acknowledge(const CommandReport& command, bool rises) RT_SAFE {
  if (state_ != DeviceState::fault || !rises || clear_us_ < clear_us) return;
  state_ = homed_ == all_homed ? DeviceState::ready : DeviceState::unhomed;
  fault_ = DeviceFault::none;
  spent_ = command.mode;
  holds_ = true;
  held_us_ = calm_us_ = 0;
}

void DeviceStateMachine::advance(const DeviceInputs& in, const CommandReport& command) RT_SAFE {
  const bool wants_home = command.mode == CommandMode::home && spent_ != CommandMode::home;
  switch (state_) {
    case DeviceState::unhomed:
    case DeviceState::ready:
      if (wants_home) {
        state_ = DeviceState::homing;
        homed_ = 0;
        homing_us_ = 0;
      } else if (state_ == DeviceState::ready) {
        engage(in, command);
      }
      break;
    case DeviceState::homing:
      home(in, command);
      break;
    case DeviceState::engaged:
      if (command.mode != CommandMode::render || !in.dead_man) {
        state_ = DeviceState::ready;
        spent_ = command.mode;
        calm_us_ = 0;
      } else {
        count_up(ramp_us_, elapsed_us_, ramp_us);
      }
      break;
    case DeviceState::fault:
      break;
  }
}

void DeviceStateMachine::home(const DeviceInputs& in, const CommandReport& command) RT_SAFE {
  homed_ = static_cast<std::uint8_t>(homed_ | (in.found & all_homed));
  count_up(homing_us_, elapsed_us_, homing_us);
  if (command.mode != CommandMode::home) {
    state_ = DeviceState::unhomed;
    homed_ = 0;
  } else if (homed_ == all_homed) {
    state_ = DeviceState::ready;
    spent_ = CommandMode::home;
    holds_ = true;
    held_us_ = calm_us_ = 0;
  } else if (homing_us_ >= homing_us) {
    fail(DeviceFault::homing);
  }
}

void DeviceStateMachine::engage(const DeviceInputs& in, const CommandReport& command) RT_SAFE {
  const bool held = command.mode == CommandMode::hold || command.mode == CommandMode::render;
  const bool held_first = held_us_ >= hold_first_us;
  if (held)
    count_up(held_us_, elapsed_us_, hold_first_us);
  else
    held_us_ = 0;
  if (held_first && calm(in, command))
    count_up(calm_us_, elapsed_us_, calm_us);
  else
    calm_us_ = 0;
  if (calm_us_ < calm_us) return;
  state_ = DeviceState::engaged;
  spent_ = CommandMode::render;
  ramp_us_ = 0;
}

bool DeviceStateMachine::calm(const DeviceInputs& in, const CommandReport& command) const RT_SAFE {
  if (command.mode != CommandMode::render || spent_ == CommandMode::render || !in.dead_man ||
      motion_.faster_than(rules_.calm_speed))
    return false;
  for (std::size_t i = 0; i < axes; ++i)
    if (!(std::abs(command.effort[i]) < rules_.calm_effort[i])) return false;
  return true;
}

void DeviceStateMachine::apply(const DeviceInputs& in, const CommandReport& command) RT_SAFE {
  effort_.fill(0);
  const bool hold = holds_ && homed_ == all_homed && state_ >= DeviceState::ready &&
                    (command.mode == CommandMode::hold || command.mode == CommandMode::render);
  for (std::size_t i = 0; i < axes; ++i) {
    if (state_ == DeviceState::homing) {
      const std::int16_t most = rules_.homing_effort[i];
      effort_[i] = std::clamp(in.homing_effort[i], static_cast<std::int16_t>(-most), most);
    } else if (hold) {
      const std::int64_t rendered =
          state_ == DeviceState::engaged
              ? std::int64_t{command.effort[i]} * ramp_us_ / std::int64_t{ramp_us}
              : 0;
      effort_[i] = static_cast<std::int16_t>(command.hold[i] + rendered);
    }
  }
}

}  // namespace trocar::hid
