// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/filters/velocity_filter.hpp"

namespace trocar {

/// The backward difference: the noisiest velocity and the least late.
///
///   v_k = (x_k - x_{k-1}) / dt        late by T / 2; one count r makes a step of r / T
class BackwardDifference {
 public:
  void reset(double position) RT_SAFE { last_ = position; }
  double update(double position, double dt) RT_SAFE {
    const double rate = (position - last_) / dt;
    last_ = position;
    return rate;
  }

 private:
  double last_ = 0.0;
};

/// A BackwardDifference for each number of a signal.
class Difference final : public VelocityFilter {
 public:
  /// @throw std::invalid_argument for a rotation.
  void configure(const Setup& setup) override;

 private:
  void reset(std::size_t i, double now) RT_SAFE override { filters_[i].reset(now); }
  double update(std::size_t i, double now, double dt) RT_SAFE override {
    return filters_[i].update(now, dt);
  }
  std::vector<BackwardDifference> filters_;
};

}  // namespace trocar
