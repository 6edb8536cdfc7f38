// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/sources/waveform.hpp"

namespace trocar {

/// A sine whose frequency moves linearly from one value to another:
///
///   f(t)  = f0 + (f1 - f0) t / D                          [Hz]
///   φ(t)  = 2 π (f0 t + (f1 - f0) t² / (2 D))             [rad], the exact integral of 2 π f
///   value = A w(t) sin φ(t)   for 0 <= t < D, else 0
///
/// w rises as (1 - cos(π t / taper)) / 2 at the beginning and falls likewise at the end.
struct LinearSweep {
  double amplitude = 1.0;  // A
  double from = 0.1;       // f0 [Hz]
  double to = 1.0;         // f1 [Hz]
  double duration = 10.0;  // D [s]
  double taper = 0.0;      // [s], at most D / 2
  double at(double t) const RT_SAFE;
  double frequency(double t) const RT_SAFE;  // 0 outside
};

/// A LinearSweep with ports.
class Chirp final : public Waveform {
 public:
  /// @throw std::invalid_argument for tapers that overlap or a wiring to another unit.
  void configure(const Setup& setup) override;
  void start() override;
  void step(const Tick& tick) RT_SAFE override;

  Output<double> frequency{
      this, "frequency", {.unit = "Hz", .doc = "at this moment; 0 once it is over"}};
  Parameter<Quantity> amplitude{
      this, "amplitude", {.doc = "of the swing between the tapers, e.g. \"20 mm\""}};
  Parameter<double> from{this,
                         "from",
                         {.unit = "Hz",
                          .initial = "0.1 Hz",
                          .min = "0 Hz",
                          .max = "1000 Hz",
                          .doc = "frequency at the beginning"}};
  Parameter<double> to{this,
                       "to",
                       {.unit = "Hz",
                        .initial = "1 Hz",
                        .min = "0 Hz",
                        .max = "1000 Hz",
                        .doc = "frequency at the end"}};
  Parameter<double> duration{this,
                             "duration",
                             {.unit = "s",
                              .initial = "20 s",
                              .min = "1 ms",
                              .max = "3600 s",
                              .doc = "from beginning to end"}};
  Parameter<double> taper{this,
                          "taper",
                          {.unit = "s",
                           .initial = "0 s",
                           .min = "0 s",
                           .doc = "of the rise at the beginning and of the fall at the end"}};

 private:
  const Parameter<Quantity>& scale() const override { return amplitude; }
  void write(double t) RT_SAFE;
  LinearSweep sweep_;
};

}  // namespace trocar
