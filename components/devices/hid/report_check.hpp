// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/hid/state_report.hpp"

namespace trocar::hid {

/// What became of a received report. Only `state` is taken for state.
enum class ReportVerdict : std::uint8_t {
  state,
  page,  // an answer to a page request: no state, and not wrong
  too_short,
  too_long,
  corrupted,
  foreign,
  malformed,
  repeated,   // the sequence of the last one
  reordered,  // an older sequence
  stale,      // a new sequence with a device time that did not move on, or too long under way
  encoder_jump,
  unhomed_by_jump  // after a jump, until the device was homed anew
};

struct ReportCheckSettings {
  PerAxis<double> speed{};             // v_max of each axis [counts/s]
  std::int64_t oldest_ns = 3'000'000;  // age from which a report is stale
};

/// The host's judgement of the report stream, for one session with a device. Sequence and device
/// time wrap; both are compared by their difference.
///
///   lost   += sequence_k - sequence_k-1 - 1
///   age     = arrival - device time - offset,   offset_k = min(offset_k-1 + 2e-4 dt, arrival -
///             device time): the fastest way so far, which may drift by what two crystals do
///   jump:     |n_k - n_k-1| > 2 v_max dt + 1 count, between two reports that are homed
///
/// A device that starts anew begins with other numbers: the driver makes a new session by reset().
/// Silence is not seen here but by age_ns().
class ReportCheck {
 public:
  static constexpr std::size_t verdicts = 12;

  explicit ReportCheck(const ReportCheckSettings& settings) : settings_(settings) {}

  /// Forgets device and position; counts go on, and a jump still asks for homing.
  void reset() RT_SAFE;
  /// @param arrival_ns of the host's monotonic clock
  ReportVerdict take(ReportBytes bytes, std::int64_t arrival_ns) RT_SAFE;

  bool any() const RT_SAFE { return any_; }                    // a state was taken in this session
  const StateReport& state() const RT_SAFE { return state_; }  // taken last
  std::int64_t device_time_us() const RT_SAFE { return device_us_; }  // of state(), does not wrap
  /// A report's time under way beyond the fastest, and the time since it arrived.
  std::int64_t age_ns(std::int64_t now_ns) const RT_SAFE {
    return under_way_ns_ + now_ns - arrival_ns_;
  }
  std::uint64_t lost() const RT_SAFE { return lost_; }
  std::uint64_t count(ReportVerdict verdict) const RT_SAFE {
    return counts_[static_cast<std::size_t>(verdict)];
  }

 private:
  ReportVerdict judge(ReportBytes bytes, std::int64_t arrival_ns) RT_SAFE;
  ReportVerdict follow(const StateReport& next, std::int64_t arrival_ns) RT_SAFE;
  bool jumps(const StateReport& next, std::int32_t elapsed_us) const RT_SAFE;
  void accept(const StateReport& next, std::int64_t device_us, std::int64_t arrival_ns) RT_SAFE;

  ReportCheckSettings settings_;
  StateReport state_;
  bool any_ = false;
  bool jumped_ = false;
  std::uint16_t sequence_ = 0;  // newest seen, taken or not
  std::int64_t device_us_ = 0;
  std::int64_t seen_us_ = 0;  // newest device time, taken or not
  std::int64_t arrival_ns_ = 0, offset_ns_ = 0, under_way_ns_ = 0;
  std::uint64_t lost_ = 0;
  std::array<std::uint64_t, verdicts> counts_{};
};

}  // namespace trocar::hid
