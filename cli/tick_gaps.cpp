// SPDX-License-Identifier: Apache-2.0
#include "cli/tick_gaps.hpp"

#include <algorithm>

namespace trocar::cli {

void TickGaps::add(std::int64_t tick, std::int64_t time_ns, bool skipped) {
  // Unsigned, since a damaged log may hold any two numbers.
  const auto distance = static_cast<std::int64_t>(static_cast<std::uint64_t>(tick) -
                                                  static_cast<std::uint64_t>(tick_));
  if (runs_ == 0 || tick <= tick_ || distance <= 0) {
    ++runs_;
  } else {
    ++(skipped ? skipped_ : lost_)[distance];
    if (!skipped) first_tick_.emplace(distance, tick_);
    ticks_spanned_ += static_cast<double>(distance);
    time_spanned_ += 1e-9 * (static_cast<double>(time_ns) - static_cast<double>(time_ns_));
  }
  tick_ = tick;
  time_ns_ = time_ns;
}

std::int64_t TickGaps::step() const {
  if (lost_.empty()) return 1;
  return lost_.begin()->first;
}

std::uint64_t TickGaps::missing(const Distances& distances) const {
  std::uint64_t rows = 0;
  for (const auto& [distance, count] : distances)
    rows += count * static_cast<std::uint64_t>((distance - 1) / step());
  return rows;
}

std::uint64_t TickGaps::gaps() const {
  std::uint64_t gaps = 0;
  for (const auto& [distance, count] : lost_)
    if (distance > step()) gaps += count;
  return gaps;
}

std::optional<std::int64_t> TickGaps::first_gap() const {
  std::optional<std::int64_t> first;
  for (const auto& [distance, tick] : first_tick_)
    if (distance > step()) first = first ? std::min(*first, tick) : tick;
  return first;
}

double TickGaps::rate() const {
  if (!(time_spanned_ > 0.0)) return 0.0;
  return ticks_spanned_ / static_cast<double>(step()) / time_spanned_;
}

double TickGaps::duration() const {
  const double hertz = rate();
  return time_spanned_ + (hertz > 0.0 ? static_cast<double>(runs_) / hertz : 0.0);
}

}  // namespace trocar::cli
