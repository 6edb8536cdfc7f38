// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/page_report.hpp"

#include <cmath>

namespace trocar::hid {
namespace {

constexpr std::size_t payload_offset = 4;
constexpr std::size_t payload_end = 60;
constexpr std::uint8_t roll_models = 3;

ReportWriter begin(ReportKind kind, const PageRequest& header, Report& report) RT_SAFE {
  report.fill(0);
  ReportWriter out(report);
  out.u8(static_cast<std::uint8_t>(kind));
  out.u8(static_cast<std::uint8_t>(header.page));
  out.u16(header.sequence);
  return out;
}

ReportDefect header_of(ReportBytes bytes, ReportKind kind, PageRequest& header) RT_SAFE {
  if (const auto defect = inspect(bytes, kind); defect != ReportDefect::none) return defect;
  ReportReader in(bytes);
  in.skip_to(1);
  const auto page = static_cast<PageNumber>(in.u8());
  if (page > PageNumber::calibration) return ReportDefect::malformed;
  header = {page, in.u16()};
  return ReportDefect::none;
}

bool positive(float value) RT_SAFE {
  return value > 0.0f && std::isfinite(value);
}

bool printable(const std::array<char, 24>& text) RT_SAFE {
  bool ended = false;
  for (const char c : text) {
    if (ended ? c != 0 : c != 0 && (c < 0x20 || c > 0x7E)) return false;
    ended = ended || c == 0;
  }
  return true;
}

bool read(ReportReader& in, IdentityPage& p) RT_SAFE {
  p.protocol = in.u8();
  p.axis_count = in.u8();
  p.firmware = in.u16();
  p.serial = in.u32();
  p.period_us = in.u16();
  p.watchdog_us = in.u16();
  for (char& c : p.model) c = static_cast<char>(in.u8());
  return p.protocol == protocol_version && p.axis_count == axes && p.period_us > 0 &&
         p.watchdog_us > 0 && printable(p.model);
}

bool read(ReportReader& in, GeometryPage& p) RT_SAFE {
  for (float* length : {&p.tool_length, &p.ring_plane, &p.ring_radius, &p.base_radius,
                        &p.platform_radius, &p.link_length})
    *length = in.f32();
  p.roll = in.u8();
  return positive(p.tool_length) && std::isfinite(p.ring_plane) && positive(p.ring_radius) &&
         positive(p.base_radius) && p.platform_radius >= 0.0f &&
         p.platform_radius < p.base_radius && positive(p.link_length) && p.roll < roll_models;
}

bool read(ReportReader& in, RangePage& p) RT_SAFE {
  for (float& low : p.lowest) low = in.f32();
  for (float& high : p.highest) high = in.f32();
  for (std::size_t i = 0; i < axes; ++i)
    if (!std::isfinite(p.lowest[i]) || !std::isfinite(p.highest[i]) ||
        !(p.lowest[i] < p.highest[i]))
      return false;
  return true;
}

bool read(ReportReader& in, LimitsPage& p) RT_SAFE {
  for (float& peak : p.peak) peak = in.f32();
  for (float& speed : p.speed) speed = in.f32();
  for (std::size_t i = 0; i < axes; ++i)
    if (!positive(p.peak[i]) || !positive(p.speed[i])) return false;
  return true;
}

bool read(ReportReader& in, CalibrationPage& p) RT_SAFE {
  for (float& unit : p.unit) unit = in.f32();
  for (std::int32_t& offset : p.offset) offset = in.i32();
  for (const float unit : p.unit)
    if (!positive(std::abs(unit))) return false;
  return true;
}

template <typename Page>
ReportDefect decode_page(ReportBytes bytes, Page& page) RT_SAFE {
  PageRequest header;
  if (const auto defect = decode_header(bytes, header); defect != ReportDefect::none) return defect;
  if (header.page != Page::number) return ReportDefect::foreign;
  ReportReader in(bytes);
  in.skip_to(payload_offset);
  Page p;
  if (!read(in, p) || !in.zeros_until(payload_end)) return ReportDefect::malformed;
  page = p;
  return ReportDefect::none;
}

}  // namespace

std::string_view IdentityPage::model_name() const RT_SAFE {
  const std::string_view all(model.data(), model.size());
  return all.substr(0, all.find('\0'));
}

void encode(const PageRequest& request, Report& report) RT_SAFE {
  begin(ReportKind::page_request, request, report);
  seal(report);
}

ReportDefect decode(ReportBytes bytes, PageRequest& request) RT_SAFE {
  PageRequest r;
  if (const auto defect = header_of(bytes, ReportKind::page_request, r);
      defect != ReportDefect::none)
    return defect;
  ReportReader in(bytes);
  in.skip_to(payload_offset);
  if (!in.zeros_until(payload_end)) return ReportDefect::malformed;
  request = r;
  return ReportDefect::none;
}

ReportDefect decode_header(ReportBytes bytes, PageRequest& answered) RT_SAFE {
  return header_of(bytes, ReportKind::page, answered);
}

void encode(const IdentityPage& page, std::uint16_t sequence, Report& report) RT_SAFE {
  ReportWriter out = begin(ReportKind::page, {page.number, sequence}, report);
  out.u8(page.protocol);
  out.u8(page.axis_count);
  out.u16(page.firmware);
  out.u32(page.serial);
  out.u16(page.period_us);
  out.u16(page.watchdog_us);
  for (const char c : page.model) out.u8(static_cast<std::uint8_t>(c));
  seal(report);
}

void encode(const GeometryPage& page, std::uint16_t sequence, Report& report) RT_SAFE {
  ReportWriter out = begin(ReportKind::page, {page.number, sequence}, report);
  for (const float length : {page.tool_length, page.ring_plane, page.ring_radius, page.base_radius,
                             page.platform_radius, page.link_length})
    out.f32(length);
  out.u8(page.roll);
  seal(report);
}

void encode(const RangePage& page, std::uint16_t sequence, Report& report) RT_SAFE {
  ReportWriter out = begin(ReportKind::page, {page.number, sequence}, report);
  for (const float low : page.lowest) out.f32(low);
  for (const float high : page.highest) out.f32(high);
  seal(report);
}

void encode(const LimitsPage& page, std::uint16_t sequence, Report& report) RT_SAFE {
  ReportWriter out = begin(ReportKind::page, {page.number, sequence}, report);
  for (const float peak : page.peak) out.f32(peak);
  for (const float speed : page.speed) out.f32(speed);
  seal(report);
}

void encode(const CalibrationPage& page, std::uint16_t sequence, Report& report) RT_SAFE {
  ReportWriter out = begin(ReportKind::page, {page.number, sequence}, report);
  for (const float unit : page.unit) out.f32(unit);
  for (const std::int32_t offset : page.offset) out.i32(offset);
  seal(report);
}

ReportDefect decode(ReportBytes bytes, IdentityPage& page) RT_SAFE {
  return decode_page(bytes, page);
}
ReportDefect decode(ReportBytes bytes, GeometryPage& page) RT_SAFE {
  return decode_page(bytes, page);
}
ReportDefect decode(ReportBytes bytes, RangePage& page) RT_SAFE {
  return decode_page(bytes, page);
}
ReportDefect decode(ReportBytes bytes, LimitsPage& page) RT_SAFE {
  return decode_page(bytes, page);
}
ReportDefect decode(ReportBytes bytes, CalibrationPage& page) RT_SAFE {
  return decode_page(bytes, page);
}

}  // namespace trocar::hid
