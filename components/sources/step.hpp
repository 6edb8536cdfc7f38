// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/sources/waveform.hpp"

namespace trocar {

/// One value until a time, another from then on:
///
///   value = from   for t < at,   to   for t >= at        t [s] since the run's start
class Step final : public Waveform {
 public:
  /// @throw std::invalid_argument for values in different units, or a wiring to another.
  void configure(const Setup& setup) override;
  void start() override { value.values()[0] = before_; }
  void step(const Tick& tick) RT_SAFE override;

  Parameter<Quantity> from{this, "from", {.initial = "0", .doc = "before the step"}};
  Parameter<Quantity> to{this, "to", {.doc = "after the step, e.g. \"5 N\""}};
  Parameter<double> at{
      this, "at", {.unit = "s", .initial = "0 s", .min = "0 s", .doc = "when it steps"}};

 private:
  const Parameter<Quantity>& scale() const override;
  double before_ = 0.0;
  double after_ = 0.0;
  std::int64_t at_ns_ = 0;  // compared as the clock counts, so that no rounding moves the step
};

}  // namespace trocar
