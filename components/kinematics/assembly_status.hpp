// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// Why a mechanism can, or cannot, be put together at the given coordinates.
enum class AssemblyStatus {
  ok,
  not_finite,
  delta_links_cannot_reach,
  delta_other_branch,
  ring_pins_cannot_reach,
  rings_other_branch,
  tool_points_backwards,
};

/// One line for a person; static text, so the loop may pass it on.
constexpr const char* describe(AssemblyStatus status) RT_SAFE {
  switch (status) {
    case AssemblyStatus::ok:
      return "assembled";
    case AssemblyStatus::not_finite:
      return "a coordinate is not a finite number";
    case AssemblyStatus::delta_links_cannot_reach:
      return "delta links cannot reach";
    case AssemblyStatus::delta_other_branch:
      return "delta platform is not in front of all sliders";
    case AssemblyStatus::ring_pins_cannot_reach:
      return "ring pins cannot reach";
    case AssemblyStatus::rings_other_branch:
      return "a spoke is turned by 90 deg or more";
    case AssemblyStatus::tool_points_backwards:
      return "tool is tilted by 90 deg or more";
  }
  return "unknown";
}

}  // namespace trocar
