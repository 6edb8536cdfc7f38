// SPDX-License-Identifier: Apache-2.0
#include "framework/executor.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace trocar {

Executor::Executor(WiredGraph& graph, ExecutorOptions options)
    : graph_(graph), options_(std::move(options)), stepper_(graph, faults_) {
  std::stable_sort(options_.schedule.begin(), options_.schedule.end(),
                   [](const Command& a, const Command& b) { return a.not_before < b.not_before; });
  for (Device* device : graph.devices()) gates_.emplace_back(*device, graph.period(), faults_);
  for (const Gate& gate : gates_) gate_states_.push_back(gate.state());
  const std::size_t count = graph.schedule().size();
  times_.resize(count);
  statistics_.components.resize(count);
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
  take_commands(tick);
  ramps_.advance();
  step_all(tick);
  pass_gates(tick);
  report_changes(tick);
  // In virtual time a full ring makes the tick wait for its readers, which is not its own cost.
  const std::int64_t end = options_.timing && simulated ? monotonic_ns() : 0;
  if (options_.records != nullptr) send_row(tick, slot);
  ++statistics_.ticks;
  statistics_.skipped += slot.skipped;
  statistics_.lateness.add(slot.lateness_ns);
  if (!options_.timing) return;
  last_duration_ = (simulated ? end : monotonic_ns()) - begin;
  statistics_.duration.add(last_duration_);
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
  if (options_.timing)
    stepper_.step(tick, {times_, statistics_.components});
  else
    stepper_.step(tick);
}

void Executor::pass_gates(const Tick& tick) RT_SAFE {
  unsigned bit = 1u;
  for (Gate& gate : gates_) {
    gate.pass(tick, (stepper_.effort_lost() & bit) == 0, (stepper_.hold_lost() & bit) == 0);
    bit <<= 1u;
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
  auto reported = gate_states_.begin();
  for (const Gate& gate : gates_) {
    Gate::State& last = *reported++;
    if (gate.state() == last) continue;
    last = gate.state();
    send({.kind = Event::Kind::gate,
          .tick = tick.index,
          .time_ns = tick.time_ns,
          .source = gate.device().name().c_str(),
          .what = to_string(last)});
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
