// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/report_bytes.hpp"

/// @file
/// What all reports of the protocol share: 64 bytes, a kind in the first, a CRC-32 in the last
/// four.

namespace trocar::hid {

constexpr std::uint8_t protocol_version = 1;

/// First byte: the protocol's version in the high half, the kind in the low one.
enum class ReportKind : std::uint8_t {
  state = 0x11,         // device to host
  command = 0x12,       // host to device
  page_request = 0x13,  // host to device
  page = 0x14           // device to host
};

/// Why bytes are not a report of the kind that was looked for.
enum class ReportDefect : std::uint8_t {
  none,
  too_short,  // fewer than 64 bytes
  too_long,   // more
  corrupted,  // its CRC is another one
  foreign,    // of another kind or version
  malformed   // a value that the protocol does not know, or values that contradict each other
};

/// CRC-32 of ISO 3309 (reflected 0x04C11DB7, start and final complement): "123456789" gives
/// 0xCBF43926.
std::uint32_t report_crc(ReportBytes bytes) RT_SAFE;

/// Writes the CRC behind the first 60 bytes.
void seal(Report& report) RT_SAFE;

/// Checks length, then CRC, then kind.
ReportDefect inspect(ReportBytes bytes, ReportKind kind) RT_SAFE;

/// a - b of numbers that wrap: negative where a is the older one (RFC 1982).
constexpr std::int16_t serial_difference(std::uint16_t a, std::uint16_t b) RT_SAFE {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(a - b));
}
constexpr std::int32_t serial_difference(std::uint32_t a, std::uint32_t b) RT_SAFE {
  return static_cast<std::int32_t>(a - b);
}

}  // namespace trocar::hid
