// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "framework/parameter.hpp"

namespace trocar {

/// Moves edited parameters to their new values along straight lines, since a step in a stiffness
/// would inject ½ ΔK e² into the hand.
class ParameterRamps {
 public:
  static constexpr std::size_t capacity = 32;

  /// False when too many move already. An edit of a moving parameter starts from where it is.
  bool begin(ParameterBase* parameter, const std::array<double, max_axes>& target,
             std::int64_t ticks) RT_SAFE;
  bool moving() const RT_SAFE { return active_ > 0; }
  /// One tick further.
  void advance() RT_SAFE;

 private:
  struct Ramp {
    ParameterBase* parameter = nullptr;
    std::array<double, max_axes> start{};
    std::array<double, max_axes> target{};
    std::int64_t done = 0;
    std::int64_t ticks = 1;
  };
  std::array<Ramp, capacity> ramps_{};
  std::size_t active_ = 0;
};

}  // namespace trocar
