// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/sources/waveform.hpp"

namespace trocar {

/// value = o + A sin(2 π f t + φ), t [s] since the run's start.
struct SineWave {
  double amplitude = 1.0;  // A
  double frequency = 1.0;  // f [Hz]
  double phase = 0.0;      // φ [rad]
  double offset = 0.0;     // o, in the unit of A
  double at(double t) const RT_SAFE;
};

/// A SineWave with ports.
class Sine final : public Waveform {
 public:
  /// @throw std::invalid_argument for an offset in another unit, or a wiring to one.
  void configure(const Setup& setup) override;
  void start() override { value.values()[0] = wave_.at(0.0); }
  void step(const Tick& tick) RT_SAFE override;

  Parameter<Quantity> amplitude{
      this, "amplitude", {.doc = "of the swing about the offset, e.g. \"3 mm\""}};
  Parameter<double> frequency{this,
                              "frequency",
                              {.unit = "Hz",
                               .initial = "1 Hz",
                               .min = "0 Hz",
                               .max = "1000 Hz",
                               .doc = "swings in a second"}};
  Parameter<double> phase{
      this, "phase", {.unit = "rad", .initial = "0 deg", .doc = "of the sine at the run's start"}};
  Parameter<Quantity> offset{
      this, "offset", {.initial = "0", .doc = "of the middle, in the amplitude's unit"}};

 private:
  const Parameter<Quantity>& scale() const override { return amplitude; }
  SineWave wave_;
};

}  // namespace trocar
