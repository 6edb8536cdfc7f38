// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "framework/executor.hpp"

namespace trocar {

void Executor::obey(const Command& command, const Tick& tick) RT_SAFE {
  edited_ = true;
  Event event{.tick = tick.index, .time_ns = tick.time_ns};
  switch (command.kind) {
    case Command::Kind::set_parameter: {
      const auto ticks =
          static_cast<std::int64_t>(std::lround(options_.edit_ramp / group_.period()));
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
    case Command::Kind::home:
      for (Gate& gate : gates_) {
        event.source = gate.device().name().c_str();
        const char* refused = gate.request_home();
        event.kind = refused == nullptr ? Event::Kind::homing : Event::Kind::homing_refused;
        event.detail = refused == nullptr ? "" : refused;
        send(event);
      }
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
      end();
      return;
    case Command::Kind::annotate:
      event.kind = Event::Kind::annotated;
      event.detail = command.text;
      send(event);
      return;
    case Command::Kind::reload:
      command.ticket->prepare(tick.time);
      replace(*command.ticket, event);
      return;
    case Command::Kind::replace:
      replace(*command.ticket, event);
      return;
  }
}

void Executor::replace(ReloadTicket& ticket, Event event) RT_SAFE {
  if (ticket.ready()) return ticket.replace();
  event.kind = Event::Kind::reload_refused;
  event.source = ticket.owner();
  event.detail = ticket.trouble();
  send(event);
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

}  // namespace trocar
