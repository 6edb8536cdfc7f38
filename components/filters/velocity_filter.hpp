// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"

namespace trocar {

/// What velocity estimators share: a signal of any numbers goes in, its rate in [unit/s] comes out,
/// of the same type and in the same frame.
class VelocityFilter : public Component {
 public:
  void unify() override;
  void start() override { started_ = false; }
  void step(const Tick& tick) RT_SAFE override;

  GenericInput position{this, "position", {.doc = "of what moves; Joints, Vector3 or a number"}};
  GenericOutput velocity{this, "velocity", {.doc = "of the position, at rest until it moves"}};

 protected:
  /// Numbers in the position.
  /// @throw std::invalid_argument for a rotation, whose rate is not that of its numbers.
  std::size_t count() const;
  /// States how the velocity follows from the position.
  /// @param late [s] behind the position
  /// @param span [s] over which one count of the position is spread
  void state_quality(double late, double span);
  /// Takes the i-th number as at rest.
  virtual void reset(std::size_t i, double now) RT_SAFE = 0;
  /// @return the i-th number's rate
  virtual double update(std::size_t i, double now, double dt) RT_SAFE = 0;

 private:
  std::size_t count_ = 0;
  bool started_ = false;
};

}  // namespace trocar
