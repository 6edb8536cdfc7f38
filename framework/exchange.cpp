// SPDX-License-Identifier: Apache-2.0
#include "framework/exchange.hpp"

namespace trocar {

void Exchange::receive_one(const Arrival& arrival, const Tick& tick, bool simulated) RT_SAFE {
  arrival.crossing->receive(tick, simulated);
  const char* why = arrival.crossing->lost();
  if (why == nullptr) return;
  const ScheduleItem& reader = group_.schedule()[arrival.item];
  const bool stale = arrival.crossing->info().age > arrival.crossing->connection().stale;
  faults_.raise({.cause = FaultCause::signal_lost,
                 .component = reader.component->name().c_str(),
                 .detail = why,
                 .value = stale ? arrival.crossing->info().age : 0.0,
                 .limit = stale ? arrival.crossing->connection().stale : 0.0,
                 .tick = tick.index,
                 .time_ns = tick.time_ns});
  lost_.effort |= reader.reaches_effort;
  lost_.hold |= reader.reaches_hold;
  lost_.crossing |= reader.reaches_crossing;
}

void Exchange::send_one(const Departure& departure, const Tick& tick, bool sound) RT_SAFE {
  if (departure.crossing->send(tick, sound)) return;
  faults_.raise({.cause = FaultCause::queue_full,
                 .component = group_.schedule()[departure.item].component->name().c_str(),
                 .detail = departure.crossing->text().c_str(),
                 .tick = tick.index,
                 .time_ns = tick.time_ns});
}

}  // namespace trocar
