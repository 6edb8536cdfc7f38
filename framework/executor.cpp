// SPDX-License-Identifier: Apache-2.0
#include "framework/executor.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "framework/supervisor.hpp"

namespace trocar {

Executor::Executor(const RateGroup& group, ExecutorOptions options)
    : group_(group),
      options_(std::move(options)),
      stepper_(group, faults_),
      exchange_(group, faults_),
      overload_(options_.overload, group.period()) {
  std::stable_sort(options_.schedule.begin(), options_.schedule.end(),
                   [](const Command& a, const Command& b) { return a.not_before < b.not_before; });
  scheduled_ = options_.schedule;
  for (Device* device : group.devices()) gates_.emplace_back(*device, group.period(), faults_);
  for (const Gate& gate : gates_) gate_states_.push_back(gate.state());
  const std::size_t count = group.schedule().size();
  for (const ScheduleItem& item : group.schedule())
    if (item.component->wants_slack()) in_slack_.push_back(item.component);
  for (const ScheduleItem& item : group.schedule())
    if (auto* part = dynamic_cast<Replaceable*>(item.component))
      parts_.push_back({part, item.component->name().c_str()});
  times_.resize(count);
  statistics_.components.resize(count);
  if (options_.allocations != nullptr) statistics_.costs.resize(count);
}

void Executor::run(Clock& clock) {
  start();
  clock.start(group_.period_ns());
  loop(clock);
}

bool Executor::over() const RT_SAFE {
  const auto raised = [](const StopFlag* flag) { return flag != nullptr && flag->raised(); };
  return ended_ || raised(options_.stop) || raised(options_.end_all) ||
         (options_.ticks >= 0 && statistics_.ticks + statistics_.skipped >= options_.ticks);
}

void Executor::loop(Clock& clock) {
  Slot slot;
  while (!over()) {
    slot = clock.wait();
    tick(slot, clock.simulated());
  }
  statistics_.spun_ns = clock.spun_ns();
  stop(slot, clock.simulated());
}

void Executor::end() RT_SAFE {
  ended_ = true;
  if (options_.end_all != nullptr) options_.end_all->raise();
}

void Executor::start() {
  for (const ScheduleItem& item : group_.schedule()) item.component->start();
  send({.kind = Event::Kind::started});
}

void Executor::stop(const Slot& last, bool simulated) RT_SAFE {
  simulated_ = simulated;
  send({.kind = Event::Kind::ended, .tick = last.index, .time_ns = tick_of(last.index).time_ns});
  for (auto item = group_.schedule().rbegin(); item != group_.schedule().rend(); ++item)
    item->component->stop();
}

void Executor::tick(const Slot& slot, bool simulated) RT_SAFE {
  simulated_ = simulated;
  const std::int64_t begin = options_.timing ? monotonic_ns() : 0;
  const Tick tick = tick_of(slot.index);
  judge_time(tick, slot);
  if (slot.date_ns != 0)
    if (const std::int64_t silent_ns = heartbeat_.beat(slot.date_ns); silent_ns > 0)
      judge_silence(tick, silent_ns);
  take_commands(tick);
  move_ramps();
  exchange_.receive(tick, simulated);
  step_all(tick, begin);
  if (!gates_.empty()) pass_gates(tick);
  send_across(tick);
  report_changes(tick);
  // In virtual time a full ring makes the tick wait for its readers, which is not its own cost.
  const std::int64_t end = options_.timing && simulated ? monotonic_ns() : 0;
  if (options_.records != nullptr) send_row(tick, slot);
  ++statistics_.ticks;
  statistics_.skipped += slot.skipped;
  statistics_.lateness.add(slot.lateness_ns);
  if (options_.timing) {
    last_duration_ = (simulated ? end : monotonic_ns()) - begin;
    statistics_.duration.add(last_duration_);
    if (options_.allocations != nullptr) statistics_.tick_cost.add(tick.index, last_duration_, 0);
  }
  if (!in_slack_.empty()) use_slack();
}

/// In virtual time always: what is done may not depend on how long something took.
void Executor::use_slack() RT_SAFE {
  if (!simulated_ && 2 * last_duration_ > group_.period_ns()) return;
  for (Component* component : in_slack_) component->use_slack();
}

inline Tick Executor::tick_of(std::int64_t index) const RT_SAFE {
  const std::int64_t time_ns = group_.phase_ns() + index * group_.period_ns();
  return {index, time_ns, static_cast<double>(time_ns) * 1e-9, group_.period()};
}

/// The tick before, whose end is known now.
inline void Executor::judge_time(const Tick& tick, const Slot& slot) RT_SAFE {
  const Overload overload = overload_.judge(slot);
  statistics_.overruns = overload_.overruns();
  if (overload.detail != nullptr) react_to(overload, tick);
}

void Executor::react_to(const Overload& overload, const Tick& tick) RT_SAFE {
  give_up_rendering({.cause = FaultCause::overload,
                     .component = group_.name().c_str(),
                     .detail = overload.detail,
                     .value = overload.value,
                     .limit = overload.limit,
                     .tick = tick.index,
                     .time_ns = tick.time_ns});
}

/// Whose step took most of a silence: that of a component in the tick before, or nobody's here.
const char* Executor::who_was_silent(std::int64_t silent_ns) const RT_SAFE {
  const auto longest = std::max_element(times_.begin(), times_.end());
  if (longest == times_.end() || 2 * *longest < silent_ns) return group_.name().c_str();
  const auto at = static_cast<std::size_t>(longest - times_.begin());
  return group_.schedule()[at].component->name().c_str();
}

/// The supervisor has told the devices by now; this is what the loop makes of it afterwards.
void Executor::judge_silence(const Tick& tick, std::int64_t silent_ns) RT_SAFE {
  if (overload_.in_grace(tick.index) || overload_policy() == OverloadPolicy::ignore) return;
  give_up_rendering({.cause = FaultCause::loop_stalled,
                     .component = who_was_silent(silent_ns),
                     .detail = "no tick began for so long [s]",
                     .value = static_cast<double>(silent_ns) * 1e-9,
                     .limit = static_cast<double>(heartbeat_patience(group_.period_ns())) * 1e-9,
                     .tick = tick.index,
                     .time_ns = tick.time_ns});
}

void Executor::give_up_rendering(const Fault& fault) RT_SAFE {
  faults_.raise(fault);
  for (Gate& gate : gates_) gate.stop_rendering(fault);
  if (overload_policy() == OverloadPolicy::end) end();
}

inline void Executor::take_commands(const Tick& tick) RT_SAFE {
  while (!scheduled_.empty() && scheduled_.front().not_before <= tick.index) {
    obey(scheduled_.front(), tick);
    scheduled_ = scheduled_.subspan(1);
  }
  if (options_.commands == nullptr) return;
  while (const auto command = options_.commands->try_pop()) obey(*command, tick);
}

inline void Executor::move_ramps() RT_SAFE {
  if (!ramps_.moving()) return;
  edited_ = true;
  ramps_.advance();
}

/// Where nothing came before the first component, the tick's beginning is its own.
inline void Executor::step_all(const Tick& tick, std::int64_t begin) RT_SAFE {
  if (!options_.timing) return stepper_.step(tick);
  const bool first = !std::exchange(edited_, false) && group_.arrivals().empty();
  stepper_.step(
      tick, first ? begin : monotonic_ns(),
      {times_, statistics_.components, !simulated_, options_.allocations, statistics_.costs});
}

void Executor::pass_gates(const Tick& tick) RT_SAFE {
  const unsigned effort_lost = stepper_.effort_lost() | exchange_.lost().effort;
  const unsigned hold_lost = stepper_.hold_lost() | exchange_.lost().hold;
  unsigned bit = 1;
  for (Gate& gate : gates_) {
    gate.pass(tick, (effort_lost & bit) == 0, (hold_lost & bit) == 0);
    bit <<= 1;
  }
}

inline void Executor::send_across(const Tick& tick) RT_SAFE {
  exchange_.send(tick, stepper_.crossing_lost(),
                 [this](std::size_t i) { return stepper_.stepped(i); });
}

inline void Executor::report_changes(const Tick& tick) RT_SAFE {
  if (faults_reported_ < faults_.size()) report_faults();
  if (!gates_.empty()) report_gates(tick);
  if (!parts_.empty()) report_reloads(tick);
}

void Executor::report_reloads(const Tick& tick) RT_SAFE {
  for (const Part& one : parts_) {
    Event event;
    while (one.part->take_news(event)) {
      event.tick = tick.index;
      event.time_ns = tick.time_ns;
      event.source = one.owner;
      send(event);
    }
  }
}

void Executor::report_gates(const Tick& tick) RT_SAFE {
  auto reported = gate_states_.begin();
  for (const Gate& gate : gates_) {
    Gate::State& before = *reported++;
    if (gate.state() == before) continue;
    before = gate.state();
    send({.kind = Event::Kind::gate,
          .tick = tick.index,
          .time_ns = tick.time_ns,
          .source = gate.device().name().c_str(),
          .what = to_string(gate.state())});
  }
}

void Executor::report_faults() RT_SAFE {
  for (; faults_reported_ < faults_.size(); ++faults_reported_) {
    const Fault& fault = faults_[faults_reported_];
    send({.kind = Event::Kind::fault,
          .tick = fault.tick,
          .time_ns = fault.time_ns,
          .source = fault.component,
          .what = to_string(fault.cause),
          .detail = fault.detail,
          .value = fault.value,
          .limit = fault.limit});
  }
}

void Executor::hand_over(RecordKind kind) RT_SAFE {
  const std::uint32_t tag = record_tag(kind, options_.index);
  if (simulated_)
    options_.records->commit_when_read(tag);
  else
    options_.records->commit(tag);
}

void Executor::send(const Event& event) RT_SAFE {
  if (options_.records == nullptr) return;
  const std::span<std::byte> record = options_.records->begin(sizeof event);
  if (record.empty()) {
    ++statistics_.rows_lost;
    return;
  }
  std::memcpy(record.data(), &event, sizeof event);
  hand_over(RecordKind::event);
}

void Executor::send_row(const Tick& tick, const Slot& slot) RT_SAFE {
  const std::span<std::byte> row = options_.records->begin(options_.layout->size());
  if (row.empty()) {
    ++statistics_.rows_lost;
    return;
  }
  RowHeader header{.tick = tick.index, .time = tick.time_ns};
  const bool rendering = std::any_of(gates_.begin(), gates_.end(), [](const Gate& gate) {
    return gate.state() == Gate::State::engaged || gate.state() == Gate::State::engaging;
  });
  if (faults_.latched()) header.flags |= RowHeader::fault_latched;
  if (rendering) header.flags |= RowHeader::rendering;
  if (slot.skipped > 0) header.flags |= RowHeader::slots_skipped;
  if (simulated_) {
    std::fill(times_.begin(), times_.end(), 0);
  } else {
    header.lateness = slot.lateness_ns;
    header.duration = last_duration_;
  }
  options_.layout->capture(header, times_, group_.memory(), row);
  hand_over(RecordKind::row);
  ++statistics_.rows;
}

}  // namespace trocar
