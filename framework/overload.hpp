// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "framework/clock.hpp"

namespace trocar {

/// What follows when a loop is overloaded.
enum class OverloadPolicy {
  ignore,  // it is counted, and nothing else
  stop,    // a fault: rendering stops, hold stays, the run goes on
  end      // the same, and the run ends in order
};

/// An overrun is a tick that was not over when its next slot was due, because it took long or began
/// late; whether slots were skipped after it makes it no other. Two things are judged:
///
///   how often:  overruns that ended within the last `window`      > allowed   → trips
///   how long:   from the first deadline that was missed until the
///               end of the latest overrun of an unbroken row      > longest   → trips
///
/// A tick that ends in time breaks the row.
struct OverloadSettings {
  OverloadPolicy policy = OverloadPolicy::stop;
  double grace = 0.5;      // [s] from the start in which overruns are counted, not judged
  int allowed = 20;        // overruns in a window, 0 to 10,000
  double window = 1.0;     // [s], more than 0
  double longest = 0.020;  // [s] without a tick in time, 0 or more
};

/// What tripped; `detail` is nullptr when nothing did.
struct Overload {
  const char* detail = nullptr;
  double value = 0.0;
  double limit = 0.0;
};

/// Judges every tick of one loop. Wait-free, of fixed size.
class OverloadMonitor {
 public:
  /// @throw std::invalid_argument when a setting is out of its range
  OverloadMonitor(const OverloadSettings& settings, double period);

  /// Judges the tick that came before `slot`. Each overrun beyond a limit trips anew.
  Overload judge(const Slot& slot) RT_SAFE {
    const std::int64_t judged = before_;
    before_ = slot.index;
    if (slot.overrun_ns > 0) return judge_overrun(slot, judged);
    first_of_row_ = -1;
    return {};
  }

  const OverloadSettings& settings() const { return settings_; }
  bool in_grace(std::int64_t slot) const RT_SAFE { return slot < grace_slots_; }
  std::int64_t overruns() const { return overruns_; }  // all, also those in the grace

 private:
  Overload judge_overrun(const Slot& slot, std::int64_t judged) RT_SAFE;
  std::int64_t within_window(std::int64_t slot) RT_SAFE;

  OverloadSettings settings_;
  double period_;
  std::int64_t grace_slots_;
  std::int64_t window_slots_;
  std::vector<std::int64_t> recent_;  // slots of the latest overruns, allowed + 1 of them at most
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::int64_t overruns_ = 0;
  std::int64_t before_ = 0;         // slot of the tick that is judged next
  std::int64_t first_of_row_ = -1;  // slot of the first overrun of an unbroken row
};

}  // namespace trocar
