// SPDX-License-Identifier: Apache-2.0
#include "framework/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "framework/clock.hpp"

namespace trocar {
namespace {

constexpr std::size_t lanes = 8;  // so that no addition waits for the one before

double sum_of_last(const double* n) RT_SAFE {
  return ((n[0] + n[1]) + (n[2] + n[3])) + ((n[4] + n[5]) + (n[6] + n[7]));
}

/// Not finite where any of the numbers is not, since no addition makes an infinity or a NaN finite
/// again. A sum of finite numbers that overflows costs a search in vain. The last numbers were
/// written this moment, one by one: two of them at once could not be read before they are in the
/// cache.
double sum(std::span<const double> numbers) RT_SAFE {
  using Lanes = Eigen::Array<double, lanes, 1>;
  if (numbers.size() < lanes) return std::accumulate(numbers.begin(), numbers.end(), 0.0);
  const std::size_t last = numbers.size() - lanes;
  Lanes sums = Lanes::Zero();
  std::size_t n = 0;
  for (; n + lanes <= last; n += lanes)
    sums += Eigen::Map<const Lanes, Eigen::Aligned16>(&numbers[n]);
  double total = sums.sum();
  for (; n < last; ++n) total += numbers[n];
  return total + sum_of_last(&numbers[last]);
}

}  // namespace

Stepper::Stepper(const RateGroup& group, FaultLatch& faults) : group_(group), faults_(faults) {
  for (const ScheduleItem& item : group.schedule()) {
    Special special{.next_due = item.phase};
    find_site_force(*item.component, special);
    items_.push_back({.component = item.component,
                      .plain = item.divider == 1 && item.phase == 0 && special.force == nullptr,
                      .told = item.component->wants_duration()});
    specials_.push_back(special);
  }
}

void Stepper::find_site_force(const Component& component, Special& special) const {
  const auto& placement = component.placement();
  if (!placement || placement->force == nullptr || placement->velocity == nullptr ||
      !placement->velocity->connected() || placement->acts != Placement::Acts::through_motors)
    return;
  const auto vector_of = [](const OutputPort& output) {
    return reinterpret_cast<Vector3*>(const_cast<std::byte*>(output.data()));
  };
  const Source& source = placement->velocity->sources().front();
  special.force = vector_of(*placement->force);
  if (placement->moment != nullptr) special.moment = vector_of(*placement->moment);
  special.velocity = reinterpret_cast<const Vector3*>(source.output->data() + source.offset);
}

/// The tick itself, as long as none is missing before it: a copy of what was written this moment
/// would wait for it.
inline const Tick& Stepper::seen_by_plain(const Tick& tick, Tick& after_gap) const RT_SAFE {
  if (last_tick_ < 0 || tick.index - last_tick_ == 1) return tick;
  return after_gap = own_tick(tick, last_tick_, 1);
}

inline void Stepper::step_plain(Item& item, const Tick& own) RT_SAFE {
  item.component->step(own);
  if (item.component->failure() != nullptr) give_up(index_of(item), own);
}

/// One pass over all numbers; only when it finds something, a search for whose it is.
inline void Stepper::look_through(const Tick& tick) RT_SAFE {
  last_tick_ = tick.index;
  effort_lost_ = effort_failed_;
  hold_lost_ = hold_failed_;
  crossing_lost_ = crossing_failed_;
  if (!std::isfinite(sum(group_.numbers()))) find_not_finite(tick);
}

void Stepper::step(const Tick& tick) RT_SAFE {
  Tick after_gap;
  const Tick& every = seen_by_plain(tick, after_gap);
  for (Item& item : std::span(items_)) {
    if (item.plain)
      step_plain(item, every);
    else
      step_special(index_of(item), tick);
  }
  look_through(tick);
}

void Stepper::step(const Tick& tick, std::int64_t begin, const StepTimes& times) RT_SAFE {
  if (times.allocations == nullptr)
    step_timed<false>(tick, begin, times);
  else
    step_timed<true>(tick, begin, times);
}

/// Asked once for each tick, so that who does not count pays for no more than that.
template <bool counted>
void Stepper::step_timed(const Tick& tick, std::int64_t begin, const StepTimes& times) RT_SAFE {
  Tick after_gap;
  const Tick& every = seen_by_plain(tick, after_gap);
  std::int64_t before = begin;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    [[maybe_unused]] std::uint64_t allocated = 0;
    if constexpr (counted) allocated = times.allocations();
    if (items_[i].plain) {
      step_plain(items_[i], every);
    } else if (!step_special(i, tick)) {
      times.latest[i] = 0;
      continue;
    }
    const std::int64_t after = monotonic_ns();
    times.latest[i] = after - before;
    times.histogram[i].add(after - before);
    if constexpr (counted)
      times.costs[i].add(tick.index, after - before, times.allocations() - allocated);
    if (items_[i].told && times.tell) items_[i].component->take_duration(after - before);
    before = after;
  }
  look_through(tick);
}

/// The tick as a component sees it that steps every `divider` ticks, last in `last`.
Tick Stepper::own_tick(const Tick& tick, std::int64_t last, std::int64_t divider) const RT_SAFE {
  const double period = group_.period() * static_cast<double>(divider);
  Tick own = tick;
  own.dt = period;
  if (last >= 0 && tick.index - last != divider)
    own.dt = std::clamp(static_cast<double>(tick.index - last) * group_.period(), 0.5 * period,
                        2.0 * period);
  return own;
}

/// False where it was not due.
bool Stepper::step_special(std::size_t i, const Tick& tick) RT_SAFE {
  const ScheduleItem& item = group_.schedule()[i];
  Special& special = specials_[i];
  if (special.failed) {
    fade(special, tick);
    return false;
  }
  if (tick.index < special.next_due) return false;
  // A slot that was skipped must not cost a slow component its turn.
  special.next_due = item.phase + ((tick.index - item.phase) / item.divider + 1) * item.divider;
  const Tick own = own_tick(tick, special.last, item.divider);
  special.last = tick.index;
  if (special.force != nullptr) special.remainder.begin(*special.force);
  item.component->step(own);
  if (item.component->failure() != nullptr) give_up(i, tick);
  return true;
}

void Stepper::give_up(std::size_t i, const Tick& tick) RT_SAFE {
  const ScheduleItem& item = group_.schedule()[i];
  Special& special = specials_[i];
  items_[i].plain = false;
  special.failed = true;
  faults_.raise({.cause = FaultCause::component_failed,
                 .component = item.component->name().c_str(),
                 .detail = item.component->failure(),
                 .tick = tick.index,
                 .time_ns = tick.time_ns});
  crossing_failed_ |= item.reaches_crossing;
  if (special.force != nullptr) {
    special.last = tick.index - 1;  // it fades from now on
    fade(special, tick);
    return;
  }
  effort_failed_ |= item.reaches_effort;
  hold_failed_ |= item.reaches_hold;
  // A device that gave up reports no position, and without one nothing may be sent.
  for (std::size_t d = 0; d < group_.devices().size(); ++d)
    if (group_.devices()[d] == item.component) hold_failed_ |= 1u << d;
}

/// In every tick, also of a slow fixture: motion may turn at any time.
void Stepper::fade(Special& special, const Tick& tick) RT_SAFE {
  if (special.force == nullptr) return;
  const double elapsed = static_cast<double>(tick.index - special.last) * group_.period();
  special.last = tick.index;
  *special.force = special.remainder.step(*special.velocity, elapsed);
  if (special.moment != nullptr) *special.moment = {};
}

void Stepper::find_not_finite(const Tick& tick) RT_SAFE {
  for (const ScheduleItem& item : group_.schedule()) {
    const auto own = group_.numbers().subspan(item.begin, item.end - item.begin);
    if (std::all_of(own.begin(), own.end(), [](double x) { return std::isfinite(x); })) continue;
    faults_.raise({.cause = FaultCause::not_finite,
                   .component = item.component->name().c_str(),
                   .detail = "an output",
                   .tick = tick.index,
                   .time_ns = tick.time_ns});
    effort_lost_ |= item.reaches_effort;
    hold_lost_ |= item.reaches_hold;
    crossing_lost_ |= item.reaches_crossing;
  }
}

}  // namespace trocar
