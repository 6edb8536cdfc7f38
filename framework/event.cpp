// SPDX-License-Identifier: Apache-2.0
#include "framework/event.hpp"

namespace trocar {

const char* to_string(Event::Kind kind) RT_SAFE {
  switch (kind) {
    case Event::Kind::started:
      return "started";
    case Event::Kind::ended:
      return "ended";
    case Event::Kind::fault:
      return "fault";
    case Event::Kind::edit:
      return "edit";
    case Event::Kind::edit_refused:
      return "edit refused";
    case Event::Kind::gate:
      return "gate";
    case Event::Kind::acknowledged:
      return "acknowledged";
    case Event::Kind::acknowledge_refused:
      return "acknowledge refused";
    case Event::Kind::homing:
      return "homing";
    case Event::Kind::homing_refused:
      return "homing refused";
    case Event::Kind::reloaded:
      return "reloaded";
    case Event::Kind::reload_refused:
      return "reload refused";
    case Event::Kind::reload_undone:
      return "reload undone";
    case Event::Kind::annotated:
      return "annotated";
    case Event::Kind::rows_missed:
      return "rows missed";
  }
  return "unknown";
}

}  // namespace trocar
