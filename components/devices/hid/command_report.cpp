// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/command_report.hpp"

#include <cstdlib>

namespace trocar::hid {
namespace {

constexpr std::uint8_t mode_mask = 0x03;
constexpr std::uint8_t acknowledge_bit = 0x80;
constexpr std::size_t reserved_offset = 36;
constexpr std::size_t reserved_end = 60;

bool within_peak(const CommandReport& c) RT_SAFE {
  for (std::size_t i = 0; i < axes; ++i) {
    const int hold = c.hold[i], effort = c.effort[i];
    if (std::abs(hold) > effort_max || std::abs(effort) > effort_max ||
        std::abs(hold + effort) > effort_max)
      return false;
  }
  return true;
}

}  // namespace

void encode(const CommandReport& command, Report& report) RT_SAFE {
  report.fill(0);
  ReportWriter out(report);
  out.u8(static_cast<std::uint8_t>(ReportKind::command));
  out.u8(static_cast<std::uint8_t>(static_cast<unsigned>(command.mode) |
                                   (command.acknowledge ? acknowledge_bit : 0u)));
  out.u16(command.sequence);
  out.u32(command.tick);
  out.u32(command.deadline_us);
  for (const std::int16_t hold : command.hold) out.i16(hold);
  for (const std::int16_t effort : command.effort) out.i16(effort);
  seal(report);
}

ReportDefect decode(ReportBytes bytes, CommandReport& command) RT_SAFE {
  if (const auto defect = inspect(bytes, ReportKind::command); defect != ReportDefect::none)
    return defect;
  ReportReader in(bytes);
  in.skip_to(1);
  CommandReport c;
  const std::uint8_t flags = in.u8();
  c.mode = static_cast<CommandMode>(flags & mode_mask);
  c.acknowledge = (flags & acknowledge_bit) != 0;
  c.sequence = in.u16();
  c.tick = in.u32();
  c.deadline_us = in.u32();
  for (std::int16_t& hold : c.hold) hold = in.i16();
  for (std::int16_t& effort : c.effort) effort = in.i16();
  in.skip_to(reserved_offset);
  const bool known = (flags & ~(mode_mask | acknowledge_bit)) == 0;
  if (!known || !in.zeros_until(reserved_end) || !within_peak(c)) return ReportDefect::malformed;
  command = c;
  return ReportDefect::none;
}

}  // namespace trocar::hid
