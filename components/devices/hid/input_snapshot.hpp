// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "components/devices/hid/device_layout.hpp"

namespace trocar::hid {

/// What is known of an input device; by its reader for the loop.
struct InputSnapshot {
  static constexpr std::int64_t never = -1;

  bool attached = false;
  std::int64_t connections = 0;                        // how often it was found
  std::int64_t reports = 0;                            // taken
  std::int64_t ignored = 0;                            // of no field, or too short for theirs
  std::int64_t heard_ns = never;                       // when the last one was taken
  std::array<double, most_numbers> value{};            // of each number in the layout
  std::array<std::int64_t, most_numbers> number_ns{};  // when it came last, or never

  /// Everything is at rest, and nothing attached.
  void begin(const DeviceLayout& layout) RT_SAFE;
  void attach() RT_SAFE;
  void detach() RT_SAFE { attached = false; }
  void take(const InputLayout& layout, std::span<const std::uint8_t> bytes,
            std::int64_t now_ns) RT_SAFE;
  /// Whether an output's numbers are those to be used, by how long they are held; else it is at
  /// rest.
  /// @param stale_ns how old the report may be that they came with
  bool valid(const LayoutOutput& output, std::int64_t now_ns, std::int64_t stale_ns) const RT_SAFE;
};

}  // namespace trocar::hid
