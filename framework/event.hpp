// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
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
    homing,
    homing_refused,
    reloaded,        // a part of a component was replaced by a new version
    reload_refused,  // the new version did not reach the loop
    reload_undone,   // it did, and was given up
    annotated,       // somebody's remark
    rows_missed      // by who writes it down: `value` records before this one
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

// A record's tag says its kind, and of which thread's group it is.
constexpr std::uint32_t record_tag(RecordKind kind, std::uint32_t group) RT_SAFE {
  return group << 1 | static_cast<std::uint32_t>(kind);
}
constexpr RecordKind record_kind(std::uint32_t tag) RT_SAFE {
  return static_cast<RecordKind>(tag & 1u);
}
constexpr std::size_t record_group(std::uint32_t tag) RT_SAFE {
  return tag >> 1;
}

}  // namespace trocar
