// SPDX-License-Identifier: Apache-2.0
#include "framework/overload.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace trocar {
namespace {

constexpr int most_allowed = 10'000;
constexpr double longest_time = 3600.0;  // [s] that a setting can be

OverloadSettings checked(const OverloadSettings& settings) {
  const auto require = [](bool sound, const char* name, double value, const char* allowed) {
    if (!sound)
      throw std::invalid_argument(fmt::format("overload.{} = {:g}: {}", name, value, allowed));
  };
  const auto time = [](double value) { return value >= 0.0 && value <= longest_time; };
  require(time(settings.grace), "grace", settings.grace, "0 s to 3600 s is possible");
  require(settings.allowed >= 0 && settings.allowed <= most_allowed, "allowed", settings.allowed,
          "0 to 10000 overruns in a window are possible");
  require(time(settings.window) && settings.window > 0.0, "window", settings.window,
          "more than 0 s, up to 3600 s, is possible");
  require(time(settings.longest), "longest", settings.longest, "0 s to 3600 s is possible");
  return settings;
}

}  // namespace

OverloadMonitor::OverloadMonitor(const OverloadSettings& settings, double period)
    : settings_(checked(settings)),
      period_(period),
      grace_slots_(std::llround(settings.grace / period)),
      window_slots_(std::max(1LL, std::llround(settings.window / period))),
      recent_(static_cast<std::size_t>(settings.allowed) + 1) {}

Overload OverloadMonitor::judge_overrun(const Slot& slot, std::int64_t judged) RT_SAFE {
  ++overruns_;
  if (in_grace(slot.index) || settings_.policy == OverloadPolicy::ignore) return {};
  if (first_of_row_ < 0) first_of_row_ = judged;
  const std::int64_t often = within_window(slot.index);
  const double length = static_cast<double>(judged - first_of_row_) * period_ +
                        static_cast<double>(slot.overrun_ns) * 1e-9;
  if (length > settings_.longest)
    return {"no tick ended in time for so long [s]", length, settings_.longest};
  if (often > settings_.allowed)
    return {"overruns in the window", static_cast<double>(often),
            static_cast<double>(settings_.allowed)};
  return {};
}

/// Overruns of the last window with this one, counted up to one more than allowed.
std::int64_t OverloadMonitor::within_window(std::int64_t slot) RT_SAFE {
  const std::size_t size = recent_.size();
  const auto forget_oldest = [&] {
    oldest_ = (oldest_ + 1) % size;
    --count_;
  };
  if (count_ == size) forget_oldest();
  recent_[(oldest_ + count_++) % size] = slot;
  while (slot - recent_[oldest_] >= window_slots_) forget_oldest();
  return static_cast<std::int64_t>(count_);
}

}  // namespace trocar
