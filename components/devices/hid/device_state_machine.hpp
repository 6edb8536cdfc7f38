// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/command_intake.hpp"
#include "components/devices/hid/motion_monitor.hpp"
#include "components/devices/hid/page_report.hpp"
#include "components/devices/hid/state_report.hpp"

namespace trocar::hid {

/// What the device's rules compare with. Speeds in counts/s, efforts in peak / 32767.
struct DeviceRules {
  PerAxis<double> speed{};         // beyond it: fault
  PerAxis<double> calm_speed{};    // to engage
  PerAxis<double> calm_effort{};   // rendered, to engage
  PerAxis<double> homing_speed{};  // beyond it: fault
  PerAxis<std::int16_t> homing_effort{};
  std::uint8_t hottest = 120 + temperature_zero;  // [degC + 40]
};

/// The rules of a device whose axes 0-2 are sliders and 3-5 rings on a circle of ring_radius: calm
/// below 20 mm/s and 1 N on each slider, homing within 20 mm/s and 2 N, a ring by its pin.
/// @throw std::invalid_argument when a limit or a unit is not positive
DeviceRules device_rules(const LimitsPage& limits, const CalibrationPage& calibration,
                         double ring_radius);

/// What the firmware measured in a cycle.
struct DeviceInputs {
  std::uint32_t time_us = 0;
  PerAxis<std::int32_t> encoder{};
  PerAxis<std::uint8_t> temperature{};  // [degC + 40]
  bool dead_man = false;
  std::uint8_t found = 0;  // bit i: the reference of axis i was found now, its count set anew
  PerAxis<std::int16_t> homing_effort{};  // what the search wants
};

/// The device's side of the protocol: unhomed -> homing -> ready -> engaged, and fault. Decides
/// what reaches the motors, whatever the host says.
///
///   unhomed, homing    the host's efforts are not applied
///   ready              hold, in the modes hold and render
///   engaged            hold + ramp effort, in the mode render
///   fault              hold, if the position is trusted and commands keep coming
///
/// The diagram and the times: docs/device-protocol.md.
class DeviceStateMachine {
 public:
  static constexpr std::uint32_t hold_first_us = 1'000'000;  // before it may engage
  static constexpr std::uint32_t calm_us = 500'000;
  static constexpr std::uint32_t ramp_us = 500'000;
  static constexpr std::uint32_t clear_us = 100'000;  // nothing wrong, to acknowledge
  static constexpr std::uint32_t homing_us = 30'000'000;

  explicit DeviceStateMachine(const DeviceRules& rules);

  /// One cycle. @return effort to apply now [peak / 32767]
  const PerAxis<std::int16_t>& step(const DeviceInputs& in, CommandIntake& intake) RT_SAFE;

  DeviceState state() const RT_SAFE { return state_; }
  DeviceFault fault() const RT_SAFE { return fault_; }
  std::uint8_t homed() const RT_SAFE { return homed_; }
  const PerAxis<std::int16_t>& effort() const RT_SAFE { return effort_; }

 private:
  DeviceFault wrong_now(const DeviceInputs& in, bool went_on) const RT_SAFE;
  void fail(DeviceFault cause) RT_SAFE;
  void advance(const DeviceInputs& in, const CommandReport& command) RT_SAFE;
  void home(const DeviceInputs& in, const CommandReport& command) RT_SAFE;
  void engage(const DeviceInputs& in, const CommandReport& command) RT_SAFE;
  void acknowledge(const CommandReport& command, bool rises) RT_SAFE;
  void apply(const DeviceInputs& in, const CommandReport& command) RT_SAFE;
  bool calm(const DeviceInputs& in, const CommandReport& command) const RT_SAFE;

  DeviceRules rules_;
  MotionMonitor motion_;
  DeviceState state_ = DeviceState::unhomed;
  DeviceFault fault_ = DeviceFault::none;
  std::uint8_t homed_ = 0;
  bool holds_ = false;  // may apply hold
  CommandMode last_mode_ = CommandMode::off;
  CommandMode spent_ = CommandMode::off;  // a request that was used up, until another mode comes
  bool acknowledged_ = false;             // the flag of the last command
  bool started_ = false;
  std::uint32_t silences_ = 0;  // of the intake, seen
  std::uint32_t time_us_ = 0, elapsed_us_ = 0;
  std::uint32_t held_us_ = 0, calm_us_ = 0, ramp_us_ = 0, clear_us_ = 0, homing_us_ = 0;
  PerAxis<std::int16_t> effort_{};
};

}  // namespace trocar::hid
