// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "components/devices/hid/report_envelope.hpp"

/// @file
/// What a device tells of itself, when asked: pages of 56 bytes. Request and answer are ordinary
/// reports and not feature reports; docs/device-protocol.md says why.

namespace trocar::hid {

enum class PageNumber : std::uint8_t { identity, geometry, range, limits, calibration };

struct PageRequest {
  PageNumber page = PageNumber::identity;
  std::uint16_t sequence = 0;  // comes back in the answer
  bool operator==(const PageRequest&) const = default;
};

struct IdentityPage {
  static constexpr PageNumber number = PageNumber::identity;
  std::uint8_t protocol = protocol_version;
  std::uint8_t axis_count = axes;
  std::uint16_t firmware = 0;
  std::uint32_t serial = 0;
  std::uint16_t period_us = 1000;    // between two state reports
  std::uint16_t watchdog_us = 8000;  // without a valid command, then effort is zero
  std::array<char, 24> model{};      // printable ASCII, then zeros

  std::string_view model_name() const RT_SAFE;
  bool operator==(const IdentityPage&) const = default;
};

/// LaparoscopeGeometry, in metres.
struct GeometryPage {
  static constexpr PageNumber number = PageNumber::geometry;
  float tool_length = 0, ring_plane = 0, ring_radius = 0;
  float base_radius = 0, platform_radius = 0, link_length = 0;
  std::uint8_t roll = 0;  // RollModel
  bool operator==(const GeometryPage&) const = default;
};

struct RangePage {
  static constexpr PageNumber number = PageNumber::range;
  PerAxis<float> lowest{}, highest{};  // [m, rad]
  bool operator==(const RangePage&) const = default;
};

struct LimitsPage {
  static constexpr PageNumber number = PageNumber::limits;
  PerAxis<float> peak{};   // what 32767 stands for [N, N m]
  PerAxis<float> speed{};  // [m/s, rad/s]
  bool operator==(const LimitsPage&) const = default;
};

/// position = unit (count - offset)
struct CalibrationPage {
  static constexpr PageNumber number = PageNumber::calibration;
  PerAxis<float> unit{};           // of one count; negative where counts fall [m, rad]
  PerAxis<std::int32_t> offset{};  // [counts]
  bool operator==(const CalibrationPage&) const = default;
};

void encode(const PageRequest& request, Report& report) RT_SAFE;
ReportDefect decode(ReportBytes bytes, PageRequest& request) RT_SAFE;

/// Which page an answer holds, and to which request; the page itself may still be malformed.
ReportDefect decode_header(ReportBytes bytes, PageRequest& answered) RT_SAFE;

/// @param sequence of the request
void encode(const IdentityPage& page, std::uint16_t sequence, Report& report) RT_SAFE;
void encode(const GeometryPage& page, std::uint16_t sequence, Report& report) RT_SAFE;
void encode(const RangePage& page, std::uint16_t sequence, Report& report) RT_SAFE;
void encode(const LimitsPage& page, std::uint16_t sequence, Report& report) RT_SAFE;
void encode(const CalibrationPage& page, std::uint16_t sequence, Report& report) RT_SAFE;

/// Write the page only when they return none. Malformed are numbers that are not finite and what no
/// device can mean: no length, an empty range, no effort, a count of nothing.
ReportDefect decode(ReportBytes bytes, IdentityPage& page) RT_SAFE;
ReportDefect decode(ReportBytes bytes, GeometryPage& page) RT_SAFE;
ReportDefect decode(ReportBytes bytes, RangePage& page) RT_SAFE;
ReportDefect decode(ReportBytes bytes, LimitsPage& page) RT_SAFE;
ReportDefect decode(ReportBytes bytes, CalibrationPage& page) RT_SAFE;

}  // namespace trocar::hid
