// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/state_report.hpp"

namespace trocar::hid {
namespace {

constexpr std::uint8_t state_mask = 0x07;
constexpr std::uint8_t dead_man_bit = 0x08;

bool consistent(const StateReport& s) RT_SAFE {
  const bool needs_homed = s.state == DeviceState::ready || s.state == DeviceState::engaged;
  return s.homed <= all_homed && !(needs_homed && s.homed != all_homed) &&
         !(s.state == DeviceState::engaged && !s.dead_man) &&
         (s.state == DeviceState::fault) == (s.fault != DeviceFault::none);
}

}  // namespace

void encode(const StateReport& state, Report& report) RT_SAFE {
  ReportWriter out(report);
  out.u8(static_cast<std::uint8_t>(ReportKind::state));
  out.u8(static_cast<std::uint8_t>(static_cast<unsigned>(state.state) |
                                   (state.dead_man ? dead_man_bit : 0u)));
  out.u16(state.sequence);
  out.u32(state.time_us);
  for (const std::int32_t count : state.encoder) out.i24(count);
  for (const std::int16_t current : state.current) out.i16(current);
  for (const std::int16_t effort : state.effort) out.i16(effort);
  for (const std::uint8_t temperature : state.temperature) out.u8(temperature);
  out.u16(state.last_command);
  out.u8(state.homed);
  out.u8(static_cast<std::uint8_t>(state.fault));
  seal(report);
}

ReportDefect decode(ReportBytes bytes, StateReport& state) RT_SAFE {
  if (const auto defect = inspect(bytes, ReportKind::state); defect != ReportDefect::none)
    return defect;
  ReportReader in(bytes);
  in.skip_to(1);
  StateReport s;
  const std::uint8_t flags = in.u8();
  s.state = static_cast<DeviceState>(flags & state_mask);
  s.dead_man = (flags & dead_man_bit) != 0;
  s.sequence = in.u16();
  s.time_us = in.u32();
  for (std::int32_t& count : s.encoder) count = in.i24();
  for (std::int16_t& current : s.current) current = in.i16();
  for (std::int16_t& effort : s.effort) effort = in.i16();
  for (std::uint8_t& temperature : s.temperature) temperature = in.u8();
  s.last_command = in.u16();
  s.homed = in.u8();
  s.fault = static_cast<DeviceFault>(in.u8());
  if (flags > (state_mask | dead_man_bit) || s.state > DeviceState::fault ||
      s.fault > DeviceFault::homing || !consistent(s))
    return ReportDefect::malformed;
  state = s;
  return ReportDefect::none;
}

}  // namespace trocar::hid
