// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "framework/fault.hpp"
#include "framework/rate_group.hpp"
#include "framework/realtime/timing_histogram.hpp"
#include "framework/resist_only.hpp"
#include "framework/step_cost.hpp"

namespace trocar {

/// Where the time of each component goes, in the order of the schedule.
struct StepTimes {
  std::span<std::int64_t> latest;         // [ns] in this tick, 0 where it was not due
  std::span<TimingHistogram> histogram;   // of all ticks
  bool tell = true;                       // components that want to know; not in virtual time
  AllocationCount allocations = nullptr;  // null: costs are not kept
  std::span<StepCost> costs{};            // of all ticks
};

/// Steps the components of a schedule in their order, tick by tick, and watches over what they
/// write: numbers that are not finite, and components that give up. One that gave up is stepped no
/// more; a force that it renders at a site may only resist from then on.
///
/// Bounded, allocates nothing. A component that runs in every tick costs its own step, a look at
/// failure() and a few cycles for each number that it writes.
class Stepper {
 public:
  Stepper(const RateGroup& group, FaultLatch& faults);

  /// Steps all components that are due. Ticks come in ascending order, their `dt` is the period.
  void step(const Tick& tick) RT_SAFE;
  /// The same, with one reading of the clock for each component that is due.
  /// @param begin reading of the clock just before [ns]
  void step(const Tick& tick, std::int64_t begin, const StepTimes& times) RT_SAFE;

  /// After step(), bits as in ScheduleItem: something that a device's effort (or hold, or what is
  /// sent to another thread) is computed from was not finite in this tick or is failed for good.
  unsigned effort_lost() const RT_SAFE { return effort_lost_; }
  unsigned hold_lost() const RT_SAFE { return hold_lost_; }
  std::uint64_t crossing_lost() const RT_SAFE { return crossing_lost_; }
  /// Whether the i-th component stepped in this tick.
  bool stepped(std::size_t i) const RT_SAFE {
    return items_[i].plain || (!specials_[i].failed && specials_[i].last == last_tick_);
  }

 private:
  struct Item {  // what every tick reads
    Component* component = nullptr;
    bool plain = true;  // steps in every tick, and nothing of what follows applies
    bool told = false;  // how long it took
  };
  struct Special {  // the rest of it, for the few that need it
    std::int64_t next_due = 0;
    std::int64_t last = -1;  // tick of its last step
    bool failed = false;
    ResistOnly remainder{};
    Vector3* force = nullptr;  // that it renders at a site
    Vector3* moment = nullptr;
    const Vector3* velocity = nullptr;
  };

  void find_site_force(const Component& component, Special& special) const;
  Tick own_tick(const Tick& tick, std::int64_t last, std::int64_t divider) const RT_SAFE;
  const Tick& seen_by_plain(const Tick& tick, Tick& after_gap) const RT_SAFE;
  std::size_t index_of(const Item& item) const RT_SAFE {
    return static_cast<std::size_t>(&item - items_.data());
  }
  template <bool counted>
  void step_timed(const Tick& tick, std::int64_t begin, const StepTimes& times) RT_SAFE;
  void step_plain(Item& item, const Tick& own) RT_SAFE;
  bool step_special(std::size_t i, const Tick& tick) RT_SAFE;
  void give_up(std::size_t i, const Tick& tick) RT_SAFE;
  void fade(Special& special, const Tick& tick) RT_SAFE;
  void look_through(const Tick& tick) RT_SAFE;
  void find_not_finite(const Tick& tick) RT_SAFE;

  const RateGroup& group_;
  FaultLatch& faults_;
  std::vector<Item> items_;        // in the order of the schedule
  std::vector<Special> specials_;  // likewise
  std::int64_t last_tick_ = -1;
  unsigned effort_lost_ = 0;  // in this tick
  unsigned hold_lost_ = 0;
  std::uint64_t crossing_lost_ = 0;
  unsigned effort_failed_ = 0;  // for good
  unsigned hold_failed_ = 0;
  std::uint64_t crossing_failed_ = 0;
};

}  // namespace trocar
