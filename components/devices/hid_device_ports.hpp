// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "components/devices/hid/device_exchange.hpp"
#include "components/kinematics/laparoscope_units.hpp"
#include "framework/component.hpp"

namespace trocar {

/// What a HID device and the way to it tell of themselves, as outputs.
struct HidDevicePorts {
  explicit HidDevicePorts(Component* component) : owner(component) {}

  void update(const hid::DeviceSnapshot& snapshot, std::int64_t now_ns) RT_SAFE;
  void update(const hid::WrittenCommand& written, const hid::DeviceSnapshot& snapshot) RT_SAFE;

  Component* owner;
  Output<double> report_age{
      owner,
      "report_age",
      {.unit = "s", .doc = "of `position`, since its report left, the fastest way not counted"}};
  Output<std::int64_t> reports_lost{owner, "reports_lost", {.doc = "that never came, in all"}};
  Output<std::int64_t> reports_repeated{owner, "reports_repeated", {.doc = "in all"}};
  Output<std::int64_t> reports_refused{
      owner, "reports_refused", {.doc = "as damaged, foreign, old or impossible, in all"}};
  Output<double> write_time{owner, "write_time", {.unit = "s", .doc = "that the last write took"}};
  Output<double> round_trip{
      owner,
      "round_trip",
      {.unit = "s", .doc = "from a tick's beginning to the report that confirms its command"}};
  Output<std::int64_t> connections{
      owner, "connections", {.doc = "how often the device was found, in all"}};
  Output<Enumeration> device_state{
      owner,
      "device_state",
      {.doc = "of the device's own", .labels = {"unhomed", "homing", "ready", "engaged", "fault"}}};
  Output<Enumeration> device_fault{
      owner,
      "device_fault",
      {.doc = "that the device latched",
       .labels = {"none", "watchdog", "encoder jump", "temperature", "speed", "homing"}}};
  Output<bool> dead_man{owner, "dead_man", {.doc = "pressed"}};
  Output<Joints> temperature{
      owner,
      "temperature",
      {.unit = "K, K, K, K, K, K", .doc = "of the motors, above 0 degrees Celsius"}};

 private:
  std::array<std::int64_t, 64> begun_ns_{};  // of the ticks, by the sequence of their commands
  std::int64_t noted_ = 0;                   // number of the last of them
};

/// The device's own word for it; nullptr for none.
const char* fault_name(hid::DeviceFault fault) RT_SAFE;

}  // namespace trocar
