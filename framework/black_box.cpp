// SPDX-License-Identifier: Apache-2.0
#include "framework/black_box.hpp"

#include "framework/run.hpp"

namespace trocar {

bool FaultTrigger::event(std::size_t, const Event& event) {
  if (event.kind != Event::Kind::fault) return false;
  fault_ = event;
  return true;
}

std::string FaultTrigger::cause() const {
  return FaultRecord{.cause = fault_.what,
                     .component = fault_.source,
                     .detail = fault_.detail,
                     .value = fault_.value,
                     .limit = fault_.limit,
                     .tick = fault_.tick,
                     .time = static_cast<double>(fault_.time_ns) * 1e-9}
      .text();
}

}  // namespace trocar
