// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "components/devices/hid/report_bytes.hpp"

namespace trocar::cli {

/// When the motors of an emulated device lost their effort, in its own time, counted from what the
/// host last had to go by: the last good report that left, and the last command that was taken.
///
/// A report is good when it is a whole state report, newer than the good one before, and at most
/// `oldest_us` old when it leaves. Device time may wrap.
class EffortEnd {
 public:
  static constexpr std::int32_t oldest_us = 5'000;  // report_stale of the host, as it is at first

  void report_left(hid::ReportBytes bytes, std::uint32_t now_us);
  void command_taken(std::uint32_t now_us) { command_us_ = now_us; }
  /// Once a cycle. @param moved whether any motor has effort
  void cycle(bool moved, std::uint32_t now_us);
  /// The device starts anew, with another time.
  void forget() { *this = {}; }

  /// "effort zero 6.25 ms after the last good report and 5.00 ms after the last command", while it
  /// is zero and was not before; "" otherwise.
  std::string text() const;

 private:
  bool any_ = false;    // a good report left
  bool moved_ = false;  // in the last cycle
  bool ended_ = false;  // since then it did not move again
  std::uint16_t sequence_ = 0;
  std::uint32_t report_us_ = 0, command_us_ = 0;
  std::uint32_t after_report_us_ = 0, after_command_us_ = 0;
};

}  // namespace trocar::cli
