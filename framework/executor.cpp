// SPDX-License-Identifier: Apache-2.0
#include "framework/executor.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace trocar {

Executor::Executor(WiredGraph& graph, ExecutorOptions options)
    : graph_(graph), options_(std::move(options)), overload_(options_.overload, graph.period()) {
  std::stable_sort(options_.schedule.begin(), options_.schedule.end(),
                   [](const Command& a, const Command& b) { return a.not_before < b.not_before; });
  for (Device* device : graph.devices()) gates_.emplace_back(*device, graph.period(), faults_);
  for (const Gate& gate : gates_) gate_states_.push_back(gate.state());
  const std::size_t count = graph.schedule().size();
  states_.resize(count);
  times_.resize(count);
  statistics_.components.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    states_[i].next_due = graph.schedule()[i].phase;
    const auto& placement = graph.schedule()[i].component->placement();
    if (!placement || placement->force == nullptr || placement->velocity == nullptr ||
        !placement->velocity->connected() || placement->acts != Placement::Acts::through_motors)
      continue;
    const Source& source = placement->velocity->sources().front();
    states_[i].force = reinterpret_cast<Vector3*>(const_cast<std::byte*>(placement->force->data()));
    if (placement->moment != nullptr)
      states_[i].moment =
          reinterpret_cast<Vector3*>(const_cast<std::byte*>(placement->moment->data()));
    states_[i].velocity = reinterpret_cast<const Vector3*>(source.output->data() + source.offset);
  }
}

void Executor::run(Clock& clock) {
  start();
  clock.start(graph_.period_ns());
  Slot slot;
  while (!ended_ && !(options_.stop != nullptr && options_.stop->raised())) {
    if (options_.ticks >= 0 && statistics_.ticks + statistics_.skipped >= options_.ticks) break;
    slot = clock.wait();
    tick(slot, clock.simulated());
  }
  statistics_.spun_ns = clock.spun_ns();
  stop(slot, clock.simulated());
}

void Executor::start() {
  for (const ScheduleItem& item : graph_.schedule()) item.component->start();
  send({.kind = Event::Kind::started});
}

void Executor::stop(const Slot& last, bool simulated) RT_SAFE {
  simulated_ = simulated;
  send(
      {.kind = Event::Kind::ended, .tick = last.index, .time_ns = last.index * graph_.period_ns()});
  for (auto item = graph_.schedule().rbegin(); item != graph_.schedule().rend(); ++item)
    item->component->stop();
}

void Executor::tick(const Slot& slot, bool simulated) RT_SAFE {
  simulated_ = simulated;
  const std::int64_t begin = options_.timing ? monotonic_ns() : 0;
  const std::int64_t time_ns = slot.index * graph_.period_ns();
  const Tick tick{slot.index, time_ns, static_cast<double>(time_ns) * 1e-9, graph_.period()};
  judge_time(tick, slot);
  take_commands(tick);
  ramps_.advance();
  step_all(tick);
  effort_lost_ = effort_failed_;
  hold_lost_ = hold_failed_;
  find_not_finite(tick);
  pass_gates(tick);
  report_changes(tick);
  // In virtual time a full ring makes the tick wait for its readers, which is not its own cost.
  const std::int64_t end = options_.timing && simulated ? monotonic_ns() : 0;
  send_row(tick, slot);
  ++statistics_.ticks;
  statistics_.skipped += slot.skipped;
  statistics_.lateness.add(slot.lateness_ns);
  if (!options_.timing) return;
  last_duration_ = (simulated ? end : monotonic_ns()) - begin;
  statistics_.duration.add(last_duration_);
}

/// The tick before, whose end is known now.
void Executor::judge_time(const Tick& tick, const Slot& slot) RT_SAFE {
  const Overload overload = overload_.judge(slot);
  statistics_.overruns = overload_.overruns();
  if (overload.detail == nullptr) return;
  const Fault fault{.cause = FaultCause::overload,
                    .component = options_.name,
                    .detail = overload.detail,
                    .value = overload.value,
                    .limit = overload.limit,
                    .tick = tick.index,
                    .time_ns = tick.time_ns};
  faults_.raise(fault);
  for (Gate& gate : gates_) gate.stop_rendering(fault);
  if (overload_.settings().policy == OverloadPolicy::end) ended_ = true;
}

void Executor::take_commands(const Tick& tick) RT_SAFE {
  while (next_scheduled_ < options_.schedule.size() &&
         options_.schedule[next_scheduled_].not_before <= tick.index)
    obey(options_.schedule[next_scheduled_++], tick);
  if (options_.commands == nullptr) return;
  while (const auto command = options_.commands->try_pop()) obey(*command, tick);
}

void Executor::obey(const Command& command, const Tick& tick) RT_SAFE {
  Event event{.tick = tick.index, .time_ns = tick.time_ns};
  switch (command.kind) {
    case Command::Kind::set_parameter: {
      const auto ticks =
          static_cast<std::int64_t>(std::lround(options_.edit_ramp / graph_.period()));
      const bool taken = ramps_.begin(command.parameter, command.target, ticks);
      event.kind = taken ? Event::Kind::edit : Event::Kind::edit_refused;
      event.source = command.owner;
      event.what = command.parameter->name().c_str();
      if (!taken) event.detail = "too many edits at a time";
      event.value = command.target[0];
      send(event);
      return;
    }
    case Command::Kind::engage:
      for (Gate& gate : gates_) gate.request_engage();
      return;
    case Command::Kind::acknowledge:
      acknowledge(event);
      return;
    case Command::Kind::stop_rendering:
      for (Gate& gate : gates_)
        gate.stop_rendering({.cause = FaultCause::operator_stop,
                             .component = gate.device().name().c_str(),
                             .detail = "asked for",
                             .tick = tick.index,
                             .time_ns = tick.time_ns});
      return;
    case Command::Kind::end:
      ended_ = true;
      return;
  }
}

void Executor::acknowledge(Event event) RT_SAFE {
  const auto tripped = [](const Gate& gate) { return gate.state() == Gate::State::tripped; };
  const bool refused = !faults_.latched();
  if (refused) event.detail = "no fault is latched";
  for (Gate& gate : gates_) {
    if (!tripped(gate)) continue;
    const bool done = gate.acknowledge();
    event.kind = done ? Event::Kind::acknowledged : Event::Kind::acknowledge_refused;
    event.source = gate.device().name().c_str();
    event.detail = "";
    send(event);
  }
  if (*event.source == 0) {
    event.kind = refused ? Event::Kind::acknowledge_refused : Event::Kind::acknowledged;
    send(event);
  }
  if (std::none_of(gates_.begin(), gates_.end(), tripped)) faults_.acknowledge();
}

void Executor::step_all(const Tick& tick) RT_SAFE {
  if (!options_.timing) {
    for (std::size_t i = 0; i < states_.size(); ++i) step_one(i, tick);
    return;
  }
  std::int64_t before = monotonic_ns();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const bool stepped = step_one(i, tick);
    const std::int64_t after = monotonic_ns();
    times_[i] = after - before;
    if (stepped) statistics_.components[i].add(times_[i]);
    before = after;
  }
}

bool Executor::step_one(std::size_t i, const Tick& tick) RT_SAFE {
  const ScheduleItem& item = graph_.schedule()[i];
  ItemState& state = states_[i];
  if (state.failed) {
    fade(state, tick);
    return false;
  }
  if (tick.index < state.next_due) return false;
  // A slot that was skipped must not cost a slow component its turn.
  state.next_due = item.phase + ((tick.index - item.phase) / item.divider + 1) * item.divider;
  Tick own = tick;
  const double period = graph_.period() * static_cast<double>(item.divider);
  if (state.last >= 0)
    own.dt = std::clamp(static_cast<double>(tick.index - state.last) * graph_.period(),
                        0.5 * period, 2.0 * period);
  else
    own.dt = period;
  state.last = tick.index;
  if (state.force != nullptr) state.remainder.begin(*state.force);
  item.component->step(own);
  if (item.component->failure() != nullptr) give_up(i, tick);
  return true;
}

void Executor::give_up(std::size_t i, const Tick& tick) RT_SAFE {
  const ScheduleItem& item = graph_.schedule()[i];
  ItemState& state = states_[i];
  state.failed = true;
  faults_.raise({.cause = FaultCause::component_failed,
                 .component = item.component->name().c_str(),
                 .detail = item.component->failure(),
                 .tick = tick.index,
                 .time_ns = tick.time_ns});
  if (state.force != nullptr) {
    state.last = tick.index - 1;  // it fades from now on
    fade(state, tick);
    return;
  }
  effort_failed_ |= item.reaches_effort;
  hold_failed_ |= item.reaches_hold;
  // A device that gave up reports no position, and without one nothing may be sent.
  for (std::size_t d = 0; d < gates_.size(); ++d)
    if (&gates_[d].device() == item.component) hold_failed_ |= 1u << d;
}

/// In every tick, also of a slow fixture: motion may turn at any time.
void Executor::fade(ItemState& state, const Tick& tick) RT_SAFE {
  if (state.force == nullptr) return;
  const double elapsed = static_cast<double>(tick.index - state.last) * graph_.period();
  state.last = tick.index;
  *state.force = state.remainder.step(*state.velocity, elapsed);
  if (state.moment != nullptr) *state.moment = {};
}

/// One pass over all numbers; only when it finds something, a search for whose it is.
void Executor::find_not_finite(const Tick& tick) RT_SAFE {
  const std::span<const double> numbers = graph_.numbers();
  double sums[4] = {};
  std::size_t n = 0;
  for (; n + 4 <= numbers.size(); n += 4)
    for (std::size_t lane = 0; lane < 4; ++lane) sums[lane] += numbers[n + lane] * 0.0;
  for (; n < numbers.size(); ++n) sums[0] += numbers[n] * 0.0;
  if (sums[0] + sums[1] + sums[2] + sums[3] == 0.0) return;
  for (const ScheduleItem& item : graph_.schedule()) {
    const bool sound = std::all_of(numbers.begin() + static_cast<std::ptrdiff_t>(item.begin),
                                   numbers.begin() + static_cast<std::ptrdiff_t>(item.end),
                                   [](double x) { return std::isfinite(x); });
    if (sound) continue;
    faults_.raise({.cause = FaultCause::not_finite,
                   .component = item.component->name().c_str(),
                   .detail = "an output",
                   .tick = tick.index,
                   .time_ns = tick.time_ns});
    effort_lost_ |= item.reaches_effort;
    hold_lost_ |= item.reaches_hold;
  }
}

void Executor::pass_gates(const Tick& tick) RT_SAFE {
  for (std::size_t d = 0; d < gates_.size(); ++d) {
    const unsigned bit = 1u << d;
    gates_[d].pass(tick, (effort_lost_ & bit) == 0, (hold_lost_ & bit) == 0);
  }
}

void Executor::report_changes(const Tick& tick) RT_SAFE {
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
  for (std::size_t d = 0; d < gates_.size(); ++d) {
    if (gates_[d].state() == gate_states_[d]) continue;
    gate_states_[d] = gates_[d].state();
    send({.kind = Event::Kind::gate,
          .tick = tick.index,
          .time_ns = tick.time_ns,
          .source = gates_[d].device().name().c_str(),
          .what = to_string(gates_[d].state())});
  }
}

std::span<std::byte> Executor::room(std::size_t size) RT_SAFE {
  return simulated_ ? options_.records->begin(size) : options_.records->try_begin(size);
}

void Executor::send(const Event& event) RT_SAFE {
  if (options_.records == nullptr) return;
  const std::span<std::byte> record = room(sizeof event);
  if (record.empty()) {
    ++statistics_.rows_lost;
    return;
  }
  std::memcpy(record.data(), &event, sizeof event);
  options_.records->commit(static_cast<std::uint32_t>(RecordKind::event));
}

void Executor::send_row(const Tick& tick, const Slot& slot) RT_SAFE {
  if (options_.records == nullptr) return;
  const std::span<std::byte> row = room(options_.layout->size());
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
  options_.layout->capture(header, times_, graph_.memory(), row);
  options_.records->commit(static_cast<std::uint32_t>(RecordKind::row));
  ++statistics_.rows;
}

}  // namespace trocar
