// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace trocar::test {

struct FuzzReach {
  int states = 0, pages = 0, commands = 0;  // taken
  int refused_reports = 0, refused_commands = 0;
  unsigned device_states = 0;  // bit i: DeviceState i
};

/// Feeds one input to everything that parses a HID report, and aborts when a promise is broken.
///
/// The input is a series of reports. Each begins with a byte: 0 to 31, the 64 bytes that follow as
/// they are; 32 to 223, the same with their CRC made right, since chance would never find it; from
/// 224, as many bytes as follow, up to 96, as they are.
///
/// Promises: what is decoded encodes to the same bytes; what is refused changes nothing; a report
/// that is not state leaves the state alone; a command that is refused is not acted on; the effort
/// that the device applies is within the peak, and zero where the protocol says so.
///
/// @return what was reached, so that a corpus can be held to reach something
FuzzReach feed_hid_reports(std::span<const std::uint8_t> input);

}  // namespace trocar::test
