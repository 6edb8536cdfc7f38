// SPDX-License-Identifier: Apache-2.0
#include "framework/stepper.hpp"

#include <algorithm>
#include <cmath>

#include "framework/clock.hpp"

namespace trocar {
namespace {

/// Not finite where any of the numbers is not, since no addition makes an infinity or a NaN finite
/// again. A sum of finite numbers that overflows costs a search in vain. Eight lanes, so that no
/// addition waits for the one before.
double sum(std::span<const double> numbers) RT_SAFE {
  using Lanes = Eigen::Array<double, 8, 1>;
  Lanes sums = Lanes::Zero();
  std::size_t n = 0;
  for (; n + 8 <= numbers.size(); n += 8)
    sums += Eigen::Map<const Lanes, Eigen::Aligned16>(&numbers[n]);
  double total = sums.sum();
  for (; n < numbers.size(); ++n) total += numbers[n];
  return total;
}

}  // namespace

Stepper::Stepper(const RateGroup& group, FaultLatch& faults) : group_(group), faults_(faults) {
  for (const ScheduleItem& item : group.schedule()) {
    Special special{.next_due = item.phase};
    find_site_force(*item.component, special);
    items_.push_back({.component = item.component,
                      .plain = item.divider == 1 && item.phase == 0 && special.force == nullptr});
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

inline void Stepper::step_plain(std::size_t i, Component* component, const Tick& own) RT_SAFE {
  component->step(own);
  if (component->failure() != nullptr) give_up(i, own);
}

void Stepper::step(const Tick& tick) RT_SAFE {
  const Tick every = own_tick(tick, last_tick_, 1);
  const std::span<const Item> items = items_;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].plain)
      step_plain(i, items[i].component, every);
    else
      step_special(i, tick);
  }
  look_through(tick);
}

void Stepper::step(const Tick& tick, const StepTimes& times) RT_SAFE {
  const Tick every = own_tick(tick, last_tick_, 1);
  std::int64_t before = monotonic_ns();
  for (std::size_t i = 0; i < items_.size(); ++i) {
    if (items_[i].plain) {
      step_plain(i, items_[i].component, every);
    } else if (!step_special(i, tick)) {
      times.latest[i] = 0;
      continue;
    }
    const std::int64_t after = monotonic_ns();
    times.latest[i] = after - before;
    times.histogram[i].add(after - before);
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

/// One pass over all numbers; only when it finds something, a search for whose it is.
void Stepper::look_through(const Tick& tick) RT_SAFE {
  last_tick_ = tick.index;
  effort_lost_ = effort_failed_;
  hold_lost_ = hold_failed_;
  crossing_lost_ = crossing_failed_;
  if (!std::isfinite(sum(group_.numbers()))) find_not_finite(tick);
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
