// SPDX-License-Identifier: Apache-2.0
#include "framework/paced_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace trocar {
namespace {

constexpr std::int64_t longest_gap_ns = 1'000'000'000;  // longer: the pacer's clock started anew
constexpr std::int64_t first_beat_ns = 20'000'000;      // that the first beat has

}  // namespace

void PacedClock::start(std::int64_t period_ns) {
  const std::int64_t theirs = pacer_.period_ns();
  if (std::abs(theirs - period_ns) * 100 > period_ns)
    throw std::invalid_argument(fmt::format(
        "a rate of {:.6g} Hz cannot be paced by a device that reports at {:.6g} Hz: set rate = "
        "\"{:.6g} Hz\", or take --clock realtime",
        1e9 / static_cast<double>(period_ns), 1e9 / static_cast<double>(theirs),
        1e9 / static_cast<double>(theirs)));
  period_ns_ = period_ns;
  next_ = 0;
  any_ = false;
  // One that came before may be old: the machine was busy with the start.
  Pacer::Beat old;
  pacer_.wait_for_beat(time_.now(), old);
  begun_ns_ = time_.now() + std::max(first_beat_ns, period_ns + period_ns / 2) -
              (period_ns + period_ns / 2);
}

std::int64_t PacedClock::slot_of(const Pacer::Beat& beat) const RT_SAFE {
  const std::int64_t gone_ns = beat.own_ns - beat_.own_ns;
  if (!any_ || gone_ns <= 0 || gone_ns > longest_gap_ns) return next_;
  return std::max(next_, beat_slot_ + (gone_ns + period_ns_ / 2) / period_ns_);
}

Slot PacedClock::wait() RT_SAFE {
  const std::int64_t now = time_.now();
  const std::int64_t overrun =
      next_ > 0 ? std::max<std::int64_t>(0, now - (begun_ns_ + period_ns_)) : 0;
  Pacer::Beat beat;
  Slot slot{.index = next_, .overrun_ns = overrun};
  if (pacer_.wait_for_beat(begun_ns_ + period_ns_ + period_ns_ / 2, beat)) {
    slot.index = slot_of(beat);
    begun_ns_ = beat.date_ns;
    beat_ = beat;
    beat_slot_ = slot.index;
    any_ = true;
  } else {
    // After a tick that took long there is no catching up either.
    begun_ns_ = std::max(begun_ns_ + period_ns_, now - period_ns_ / 2);
  }
  slot.skipped = slot.index - next_;
  next_ = slot.index + 1;
  slot.date_ns = time_.now();
  slot.lateness_ns = std::max<std::int64_t>(0, slot.date_ns - begun_ns_);
  return slot;
}

}  // namespace trocar
