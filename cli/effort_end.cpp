// SPDX-License-Identifier: Apache-2.0
#include "cli/effort_end.hpp"

#include <fmt/format.h>

#include "components/devices/hid/state_report.hpp"

namespace trocar::cli {

void EffortEnd::report_left(hid::ReportBytes bytes, std::uint32_t now_us) {
  hid::StateReport state;
  if (decode(bytes, state) != hid::ReportDefect::none ||
      hid::serial_difference(now_us, state.time_us) > oldest_us ||
      (any_ && hid::serial_difference(state.sequence, sequence_) <= 0))
    return;
  any_ = true;
  sequence_ = state.sequence;
  report_us_ = now_us;
}

void EffortEnd::cycle(bool moved, std::uint32_t now_us) {
  if (moved) ended_ = false;
  if (!moved && moved_) {
    ended_ = true;
    after_report_us_ = now_us - report_us_;
    after_command_us_ = now_us - command_us_;
  }
  moved_ = moved;
}

std::string EffortEnd::text() const {
  if (!ended_) return "";
  return fmt::format(
      "effort zero {:.2f} ms after the last good report and {:.2f} ms after the last command",
      after_report_us_ * 1e-3, after_command_us_ * 1e-3);
}

}  // namespace trocar::cli
