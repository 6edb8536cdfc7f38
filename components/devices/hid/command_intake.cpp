// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/command_intake.hpp"

namespace trocar::hid {
namespace {

CommandRefusal refusal(ReportDefect defect) RT_SAFE {
  switch (defect) {
    case ReportDefect::none:
      return CommandRefusal::none;
    case ReportDefect::too_short:
      return CommandRefusal::too_short;
    case ReportDefect::too_long:
      return CommandRefusal::too_long;
    case ReportDefect::corrupted:
      return CommandRefusal::corrupted;
    case ReportDefect::foreign:
      return CommandRefusal::foreign;
    case ReportDefect::malformed:
      break;
  }
  return CommandRefusal::malformed;
}

}  // namespace

CommandRefusal CommandIntake::judge(ReportBytes bytes, std::uint32_t now_us,
                                    CommandReport& command) RT_SAFE {
  if (const auto defect = decode(bytes, command); defect != ReportDefect::none)
    return refusal(defect);
  const int newer = serial_difference(command.sequence, latest_.sequence);
  const bool alive = watch(now_us);
  if (taken() > 0 && newer == 0) return CommandRefusal::repeated;
  if (alive && newer < 0) return CommandRefusal::reordered;
  const std::int32_t left = serial_difference(command.deadline_us, now_us);
  if (left < 0) return CommandRefusal::late;
  if (left > longest_validity_us) return CommandRefusal::too_far;
  return CommandRefusal::none;
}

CommandRefusal CommandIntake::take(ReportBytes bytes, std::uint32_t now_us) RT_SAFE {
  CommandReport command;
  const CommandRefusal refused = judge(bytes, now_us, command);
  ++counts_[static_cast<std::size_t>(refused)];
  if (refused != CommandRefusal::none) return refused;
  latest_ = command;
  arrival_us_ = now_us;
  alive_ = true;
  return CommandRefusal::none;
}

bool CommandIntake::watch(std::uint32_t now_us) RT_SAFE {
  const bool expires = alive_ && now_us - arrival_us_ >= watchdog_us;
  if (expires) ++silences_;
  alive_ = alive_ && !expires;
  return alive_;
}

}  // namespace trocar::hid
