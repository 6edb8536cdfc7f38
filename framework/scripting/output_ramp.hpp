// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "framework/realtime/rt_safe.hpp"

namespace trocar::lua {

/// Numbers that go over to those of another source without a step: what they differ by at first is
/// added, and taken back along a straight line.
class OutputRamp {
 public:
  void resize(std::size_t numbers) { offsets_.assign(numbers, 0.0); }
  /// Beginning now: offsets are set by at(), and add() gives all of it.
  void begin(std::int64_t steps) RT_SAFE { left_ = steps_ = steps; }
  double& at(std::size_t i) RT_SAFE { return offsets_[i]; }
  double add(std::size_t i) const RT_SAFE {
    return left_ == 0 ? 0.0
                      : offsets_[i] * static_cast<double>(left_) / static_cast<double>(steps_);
  }
  void advance() RT_SAFE { left_ -= left_ > 0 ? 1 : 0; }
  bool moving() const RT_SAFE { return left_ > 0; }

 private:
  std::vector<double> offsets_;
  std::int64_t steps_ = 1;
  std::int64_t left_ = 0;
};

}  // namespace trocar::lua
