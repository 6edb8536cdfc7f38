// SPDX-License-Identifier: Apache-2.0
#include "gui/timing/thread_timing.hpp"

#include <algorithm>
#include <cmath>

namespace trocar::gui {
namespace {

constexpr int slots_were_skipped = 4;  // docs/log-format.md: flags of a row
constexpr std::string_view steps_prefix = "step_times.";

std::int64_t whole(double nanoseconds) {
  return std::isfinite(nanoseconds) ? std::llround(nanoseconds) : 0;
}

}  // namespace

ThreadTiming::ThreadTiming(const Track& track, double period)
    : track_(track), declared_(period), period_(period) {
  const auto lateness = track.find("lateness"), duration = track.find("duration"),
             flags = track.find("flags");
  has_times_ = lateness && duration && flags;
  if (!has_times_) return;
  lateness_column_ = *lateness;
  duration_column_ = *duration;
  flags_column_ = *flags;
  for (std::size_t i = 0; i < track.signal_list().size(); ++i)
    if (const std::string& name = track.signal_list()[i].name; name.starts_with(steps_prefix))
      components_.push_back({name.substr(steps_prefix.size()), i});
}

void ThreadTiming::forget() {
  next_ = track_.view_end();
  last_tick_ = -1;
  lateness_ = duration_ = {};
  missed_slots_ = missing_rows_ = overloads_ = 0;
  for (Component& component : components_) component.steps = {};
}

bool ThreadTiming::take(std::uint64_t most) {
  if (!has_times_) return true;
  const std::uint64_t end = track_.view_end();
  if (end < next_) {
    forget();
    next_ = 0;
  }
  if (next_ < track_.first()) {  // nobody looked, and the store let them go
    next_ = track_.first();
    last_tick_ = -1;
  }
  find_period();
  const std::uint64_t until = std::min(end, next_ + most);
  for (; next_ < until; ++next_) take_row(next_);
  return next_ >= end;
}

/// The slots' own distance, over all rows that are there: it is the same throughout a run.
void ThreadTiming::find_period() {
  if (declared_ > 0.0 || track_.end() < track_.first() + 2) return;
  const std::uint64_t first = track_.first(), last = track_.end() - 1;
  const auto ticks = static_cast<double>(track_.tick(last) - track_.tick(first));
  if (ticks > 0.0) period_ = (track_.time(last) - track_.time(first)) / ticks;
}

void ThreadTiming::take_row(std::uint64_t row) {
  const std::int64_t tick = track_.tick(row);
  const double flags = track_.column(flags_column_)[row];
  const bool skipped = std::isfinite(flags) && (std::llround(flags) & slots_were_skipped) != 0;
  if (last_tick_ >= 0 && tick > last_tick_ + 1) {
    const auto gap = static_cast<std::uint64_t>(tick - last_tick_ - 1);
    // A tick that was stepped has a row. Where the loop says that it skipped, there is none to
    // miss.
    (skipped ? missed_slots_ : missing_rows_) += gap;
  } else if (skipped) {
    ++missed_slots_;
  }
  const bool tick_before_is_known = last_tick_ >= 0;
  last_tick_ = tick;
  lateness_.add(whole(track_.column(lateness_column_)[row]));
  if (tick_before_is_known) {  // a row says how long the tick before it took
    const std::int64_t duration = whole(track_.column(duration_column_)[row]);
    duration_.add(duration);
    if (period_ > 0.0 && static_cast<double>(duration) > 1e9 * period_) ++overloads_;
  }
  for (Component& component : components_)
    if (const double step = track_.column(component.column)[row]; step > 0.0)
      component.steps.add(whole(step));
}

double ThreadTiming::least_margin() const {
  return 1e9 * period_ - static_cast<double>(duration_.max());
}

}  // namespace trocar::gui
