// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>

#include "framework/component.hpp"

namespace trocar::bench {

/// Outputs of 100 numbers that change in each tick.
class Numbers final : public Component {
 public:
  static constexpr int count = 100;

  Numbers() {
    for (int i = 0; i < count; ++i)
      outputs_.emplace_back(this, "n" + std::to_string(i), PortOptions{.unit = "N"});
  }
  void step(const Tick& tick) RT_SAFE override {
    for (Output<double>& output : outputs_) *output = tick.time;
  }

 private:
  std::deque<Output<double>> outputs_;
};

}  // namespace trocar::bench
