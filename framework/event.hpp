// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// Something that happened in a tick, beside its row. Texts live as long as the graph.
struct Event {
  enum class Kind : std::int64_t {
    started,
    ended,
    fault,
    edit,
    edit_refused,
    gate,
    acknowledged,
    acknowledge_refused,
    rows_missed  // by who writes it down: `value` records before this one
  };
  Kind kind = Kind::started;
  std::int64_t tick = 0;
  std::int64_t time_ns = 0;
  const char* source = "";  // component
  const char* what = "";    // "speed", "stiffness", "engaged"
  const char* detail = "";  // "handle"
  double value = 0.0;
  double limit = 0.0;
};

const char* to_string(Event::Kind kind) RT_SAFE;

/// What a record of the ring between the loop and its readers is.
enum class RecordKind : std::uint32_t { row, event };

}  // namespace trocar
