// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/device_state_machine.hpp"
#include "components/devices/hid/laparoscope_pages.hpp"
#include "components/devices/laparoscope_plant.hpp"

namespace trocar::hid {

struct EmulatedLaparoscopeSettings {
  LaparoscopePlantSettings plant = {};
  std::uint32_t serial = 1;
  std::uint32_t cycle_us = 250;      // of the firmware
  std::uint32_t period_us = 1000;    // between two state reports: a whole number of cycles
  std::uint32_t power_up_us = 0;     // device time at power up
  std::uint16_t first_sequence = 0;  // of state reports
  double peak_current = 10.0;        // [A] of each motor at its peak effort
};

/// A laparoscope as its host sees it through USB: the simulated plant behind the firmware of the
/// device protocol, cycle by cycle in device time, without threads, files or a clock of its own.
///
/// It powers up unhomed, its counts starting at 0 wherever it is. A multi-turn sensor behind each
/// axis tells the reference when the host asks for homing, one axis after the other, so nothing
/// moves. A brake locks the axes, and plant and hand stand still, until the effort holds the
/// weight within 1 % and 0.02 N or 2 mN m; it closes again only when power is lost.
class EmulatedLaparoscope {
 public:
  /// @throw std::invalid_argument for settings that no device can have
  explicit EmulatedLaparoscope(const EmulatedLaparoscopeSettings& settings = {});

  /// What the host sends, now.
  void receive(ReportBytes bytes) RT_SAFE;
  /// Moves on by one cycle.
  void cycle() RT_SAFE;
  /// Takes out the next report to be sent: of this cycle, or an answer. False when there is none.
  bool next(Report& report) RT_SAFE;

  // What a tester can do to it.
  void press_dead_man(bool pressed) RT_SAFE { dead_man_ = pressed; }
  void jump(std::size_t axis, std::int32_t counts) RT_SAFE { base_[axis] += counts; }
  /// All motors at so many degC, from now on; below absolute zero: as the plant has them.
  void heat(double celsius) RT_SAFE { celsius_ = celsius; }
  /// Power off and on: unhomed, with other numbers of time and sequence.
  void power_cycle();

  std::uint32_t time_us() const RT_SAFE { return time_us_; }
  std::uint32_t cycle_us() const RT_SAFE { return settings_.cycle_us; }
  const DeviceStateMachine& machine() const RT_SAFE { return machine_; }
  const CommandIntake& intake() const RT_SAFE { return intake_; }
  const LaparoscopePlant& plant() const RT_SAFE { return plant_; }
  const LaparoscopePages& pages() const RT_SAFE { return pages_; }
  bool braked() const RT_SAFE { return braked_; }
  /// Of the motors, as commanded by the firmware [N, N m].
  Vector6d effort() const RT_SAFE;

 private:
  void move() RT_SAFE;
  bool brake_lets_go() const RT_SAFE;
  DeviceInputs measure() RT_SAFE;
  void report_state() RT_SAFE;
  void answer(const PageRequest& request) RT_SAFE;
  Report* new_report() RT_SAFE;

  EmulatedLaparoscopeSettings settings_;
  LaparoscopePages pages_;
  LaparoscopePlant plant_;
  LaparoscopeGravity weight_model_;
  DeviceRules rules_;
  DeviceStateMachine machine_;
  CommandIntake intake_;
  bool braked_ = true;
  bool dead_man_ = true;
  double celsius_;
  std::uint32_t time_us_;
  std::uint32_t since_report_us_ = 0;
  std::uint32_t homing_us_ = 0;
  std::uint16_t sequence_;
  PerAxis<std::int32_t> base_{};     // counts beside the sensor's own
  PerAxis<std::int32_t> encoder_{};  // as measured last
  PerAxis<std::uint8_t> temperature_{};
  std::array<Report, 8> outbox_{};
  std::size_t waiting_ = 0;  // in the outbox
};

}  // namespace trocar::hid
