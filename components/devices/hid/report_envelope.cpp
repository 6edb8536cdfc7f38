// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/report_envelope.hpp"

namespace trocar::hid {
namespace {

constexpr std::size_t crc_offset = report_size - 4;

// Not zlib's: firmware, fuzz target and loop use one that needs nothing and promises RT_SAFE.
constexpr std::array<std::uint32_t, 256> crc_table = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320u : 0u);
    table[byte] = crc;
  }
  return table;
}();

}  // namespace

std::uint32_t report_crc(ReportBytes bytes) RT_SAFE {
  std::uint32_t crc = ~0u;
  for (const std::uint8_t byte : bytes) crc = crc_table[(crc ^ byte) & 0xFFu] ^ (crc >> 8);
  return ~crc;
}

void seal(Report& report) RT_SAFE {
  ReportWriter out(report);
  out.skip_to(crc_offset);
  out.u32(report_crc(ReportBytes(report).first<crc_offset>()));
}

ReportDefect inspect(ReportBytes bytes, ReportKind kind) RT_SAFE {
  if (bytes.size() < report_size) return ReportDefect::too_short;
  if (bytes.size() > report_size) return ReportDefect::too_long;
  ReportReader in(bytes);
  in.skip_to(crc_offset);
  if (in.u32() != report_crc(bytes.first(crc_offset))) return ReportDefect::corrupted;
  if (bytes[0] != static_cast<std::uint8_t>(kind)) return ReportDefect::foreign;
  return ReportDefect::none;
}

}  // namespace trocar::hid
