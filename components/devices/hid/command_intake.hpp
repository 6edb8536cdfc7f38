// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/command_report.hpp"

namespace trocar::hid {

/// Why the device did not take a command.
enum class CommandRefusal : std::uint8_t {
  none,
  too_short,
  too_long,
  corrupted,
  foreign,
  malformed,
  repeated,   // the sequence of the last one
  reordered,  // an older sequence
  late,       // its deadline is over
  too_far     // its deadline is farther off than any loop's
};

/// The device's end of the command stream: takes each command once and in order, while its deadline
/// is not over, and watches that they keep coming.
///
///   taken:  sequence newer than the last, 0 <= deadline - now <= 20 ms
///   alive:  now - last taken < 8 ms, and never again from the moment it failed until the next
///
/// After silence any sequence but the last is taken: a host that starts anew begins anywhere, and
/// the deadline still tells what is old.
class CommandIntake {
 public:
  static constexpr std::uint32_t watchdog_us = 8'000;
  // 3 periods at 250 Hz, the slowest loop, and a watchdog's time for the way.
  static constexpr std::int32_t longest_validity_us = 20'000;

  /// @param now_us device time, wraps
  CommandRefusal take(ReportBytes bytes, std::uint32_t now_us) RT_SAFE;
  /// Whether a command still acts. To be called in every cycle of the device, since the time wraps.
  bool watch(std::uint32_t now_us) RT_SAFE;

  /// How often the watchdog ended a command. One that ended between two cycles, because the next
  /// arrived before anybody looked, is seen by this alone.
  std::uint32_t silences() const RT_SAFE { return silences_; }

  const CommandReport& latest() const RT_SAFE { return latest_; }
  std::uint32_t taken() const RT_SAFE { return counts_[0]; }
  std::uint32_t count(CommandRefusal refusal) const RT_SAFE {
    return counts_[static_cast<std::size_t>(refusal)];
  }

 private:
  CommandRefusal judge(ReportBytes bytes, std::uint32_t now_us, CommandReport& command) RT_SAFE;

  CommandReport latest_;
  std::uint32_t arrival_us_ = 0;
  bool alive_ = false;
  std::uint32_t silences_ = 0;
  std::array<std::uint32_t, 10> counts_{};
};

}  // namespace trocar::hid
