// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/report_envelope.hpp"

namespace trocar::hid {

enum class DeviceState : std::uint8_t { unhomed, homing, ready, engaged, fault };

/// The first cause of a fault, until it is acknowledged.
enum class DeviceFault : std::uint8_t {
  none,
  watchdog,      // no valid command for 8 ms
  encoder_jump,  // the device is no longer homed
  temperature,
  speed,
  homing  // too fast, or not done in time
};

constexpr std::uint8_t all_homed = 0x3F;
constexpr std::int32_t encoder_max = 0x7FFFFF;  // counts fit in 24 bits
constexpr int temperature_zero = 40;            // a byte of 0 is -40 degC

/// What the device tells each period. Byte table: docs/device-protocol.md.
struct StateReport {
  DeviceState state = DeviceState::unhomed;
  bool dead_man = false;                // pressed
  std::uint16_t sequence = 0;           // one more each report, wraps
  std::uint32_t time_us = 0;            // of the device's clock when the encoders were read, wraps
  PerAxis<std::int32_t> encoder{};      // [counts]
  PerAxis<std::int16_t> current{};      // [mA]
  PerAxis<std::int16_t> effort{};       // applied now, hold included [peak / 32767]
  PerAxis<std::uint8_t> temperature{};  // [degC + 40]
  std::uint16_t last_command = 0;       // sequence of the command that was accepted last
  std::uint8_t homed = 0;               // bit i: axis i
  DeviceFault fault = DeviceFault::none;

  bool operator==(const StateReport&) const = default;
};

void encode(const StateReport& state, Report& report) RT_SAFE;

/// Writes `state` only when it returns none. Malformed are, beside unknown values, states that
/// contradict themselves: ready or engaged without all axes homed, engaged without dead-man, a
/// fault without a cause, a cause without a fault.
ReportDefect decode(ReportBytes bytes, StateReport& state) RT_SAFE;

}  // namespace trocar::hid
