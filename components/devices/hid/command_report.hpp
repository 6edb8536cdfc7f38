// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/report_envelope.hpp"

namespace trocar::hid {

/// What the host asks for. The device decides whether it may.
enum class CommandMode : std::uint8_t {
  off,     // all actuators at zero
  hold,    // hold alone
  render,  // hold and, once engaged, effort
  home
};

constexpr std::int16_t effort_max = 32767;  // the axis' peak effort

/// What the host sends once for each tick. Byte table: docs/device-protocol.md.
struct CommandReport {
  CommandMode mode = CommandMode::off;
  bool acknowledge = false;        // of a fault; counts when it rises
  std::uint16_t sequence = 0;      // one more each command, wraps
  std::uint32_t tick = 0;          // of the host's loop, for its logs, wraps
  std::uint32_t deadline_us = 0;   // in the device's time: not to be taken after it
  PerAxis<std::int16_t> hold{};    // [peak / 32767]
  PerAxis<std::int16_t> effort{};  // rendered [peak / 32767]

  bool operator==(const CommandReport&) const = default;
};

/// Writes also what decode() refuses.
void encode(const CommandReport& command, Report& report) RT_SAFE;

/// Writes `command` only when it returns none. Malformed is, beside unknown values, an axis with
/// |hold|, |effort| or |hold + effort| > 32767: a device that clipped it would turn the wrench.
ReportDefect decode(ReportBytes bytes, CommandReport& command) RT_SAFE;

}  // namespace trocar::hid
