// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/report_check.hpp"

#include <algorithm>
#include <cmath>

namespace trocar::hid {
namespace {

constexpr double drift = 2e-4;  // two crystals of 100 ppm
// The first report may have waited in the kernel's ring of 64, at 250 Hz 0.26 s; a clock that is
// farther ahead than that explains has leapt.
constexpr std::int64_t most_lead_ns = 1'000'000'000;

ReportVerdict verdict(ReportDefect defect) RT_SAFE {
  switch (defect) {
    case ReportDefect::none:
      return ReportVerdict::state;
    case ReportDefect::too_short:
      return ReportVerdict::too_short;
    case ReportDefect::too_long:
      return ReportVerdict::too_long;
    case ReportDefect::corrupted:
      return ReportVerdict::corrupted;
    case ReportDefect::foreign:
      return ReportVerdict::foreign;
    case ReportDefect::malformed:
      break;
  }
  return ReportVerdict::malformed;
}

}  // namespace

void ReportCheck::reset() RT_SAFE {
  state_ = {};
  any_ = false;
  sequence_ = 0;
  device_us_ = seen_us_ = arrival_ns_ = offset_ns_ = under_way_ns_ = 0;
}

ReportVerdict ReportCheck::take(ReportBytes bytes, std::int64_t arrival_ns) RT_SAFE {
  const ReportVerdict result = judge(bytes, arrival_ns);
  ++counts_[static_cast<std::size_t>(result)];
  return result;
}

ReportVerdict ReportCheck::judge(ReportBytes bytes, std::int64_t arrival_ns) RT_SAFE {
  StateReport next;
  const ReportDefect defect = decode(bytes, next);
  if (defect == ReportDefect::foreign && bytes[0] == static_cast<std::uint8_t>(ReportKind::page))
    return ReportVerdict::page;
  if (defect != ReportDefect::none) return verdict(defect);
  if (any_) return follow(next, arrival_ns);
  if (jumped_ && next.homed != 0) return ReportVerdict::unhomed_by_jump;
  jumped_ = false;
  any_ = true;
  sequence_ = next.sequence;
  seen_us_ = next.time_us;
  offset_ns_ = arrival_ns - seen_us_ * 1000;
  accept(next, next.time_us, arrival_ns);
  return ReportVerdict::state;
}

ReportVerdict ReportCheck::follow(const StateReport& next, std::int64_t arrival_ns) RT_SAFE {
  const int ahead = serial_difference(next.sequence, sequence_);
  if (ahead == 0) return ReportVerdict::repeated;
  if (ahead < 0) return ReportVerdict::reordered;
  lost_ += static_cast<std::uint64_t>(ahead - 1);
  sequence_ = next.sequence;

  const std::int32_t elapsed_us = serial_difference(next.time_us, state_.time_us);
  if (elapsed_us <= 0) return ReportVerdict::stale;
  const std::int64_t device_us = device_us_ + elapsed_us;
  const std::int64_t way = arrival_ns - device_us * 1000;
  if (way < offset_ns_ - most_lead_ns) return ReportVerdict::stale;
  const double since_seen_us = static_cast<double>(std::max<std::int64_t>(0, device_us - seen_us_));
  offset_ns_ = std::min(way, offset_ns_ + static_cast<std::int64_t>(drift * 1e3 * since_seen_us));
  seen_us_ = std::max(seen_us_, device_us);
  if (way - offset_ns_ > settings_.oldest_ns) return ReportVerdict::stale;

  // Not homed, counts mean nothing and may be set anew; homed again, they do.
  if (next.homed == 0) jumped_ = false;
  if (jumped_) return ReportVerdict::unhomed_by_jump;
  if (jumps(next, elapsed_us)) {
    jumped_ = true;
    return ReportVerdict::encoder_jump;
  }
  accept(next, device_us, arrival_ns);
  return ReportVerdict::state;
}

bool ReportCheck::jumps(const StateReport& next, std::int32_t elapsed_us) const RT_SAFE {
  const unsigned both = next.homed & state_.homed;
  for (std::size_t i = 0; i < axes; ++i) {
    const double moved = static_cast<double>(next.encoder[i]) - state_.encoder[i];
    if ((both >> i & 1u) != 0 && std::abs(moved) > 2e-6 * settings_.speed[i] * elapsed_us + 1.0)
      return true;
  }
  return false;
}

void ReportCheck::accept(const StateReport& next, std::int64_t device_us,
                         std::int64_t arrival_ns) RT_SAFE {
  state_ = next;
  device_us_ = device_us;
  arrival_ns_ = arrival_ns;
  under_way_ns_ = arrival_ns - device_us * 1000 - offset_ns_;
}

}  // namespace trocar::hid
