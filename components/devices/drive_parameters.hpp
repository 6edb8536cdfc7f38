// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/devices/declare_number.hpp"
#include "components/devices/laparoscope_plant.hpp"

namespace trocar {

/// Amplifiers, motors and encoders of the simulated device as parameters.
struct DriveParameters {
  explicit DriveParameters(ParameterSet* set) : owner(set) {}
  void apply(LaparoscopePlantSettings& settings) const;

  ParameterSet* owner;
  Parameter<double> slider_peak =
      number("slider_peak", "N", "200 N", "1 N", "200 N", "effort at which a slider saturates");
  Parameter<double> ring_peak =
      number("ring_peak", "N m", "12 N m", "0.1 N m", "12 N m", "effort at which a ring saturates");

  Parameter<bool> thermal = yes("thermal", "the peak falls to the continuous effort with heat");
  Parameter<double> slider_continuous =
      number("slider_continuous", "N", "60 N", "1 N", "200 N", "effort of a slider for ever");
  Parameter<double> ring_continuous =
      number("ring_continuous", "N m", "2.7 N m", "0.1 N m", "12 N m", "effort of a ring for ever");
  Parameter<double> winding_rise = number("winding_rise", "K", "80 K", "1 K", "200 K",
                                          "of a winding at the continuous effort, in the end");
  Parameter<double> winding_time =
      number("winding_time", "s", "60 s", "1 s", "3600 s", "constant of a winding's temperature");
  Parameter<double> derating_start = number("derating_start", "%", "80 %", "0 %", "99 %",
                                            "of winding_rise, from which the limit falls");

  Parameter<bool> gain_error = yes("gain_error", "drives give not quite what they should");
  Parameter<double> drive_gain =
      number("drive_gain", "", "0.9655", "0.5", "1.5", "given for what was sent; the mean");
  Parameter<double> gain_spread =
      number("gain_spread", "", "0.004", "0", "0.2", "of single drives about drive_gain, at most");

  Parameter<bool> gain_drift = yes("gain_drift", "warm magnets give less");
  Parameter<double> gain_loss =
      number("gain_loss", "%/K", "0.1 %/K", "0 %/K", "1 %/K", "of warm magnets");
  Parameter<double> magnet_share =
      number("magnet_share", "%", "50 %", "0 %", "100 %", "of a winding's rise at its magnets");
  Parameter<double> magnet_time =
      number("magnet_time", "s", "600 s", "1 s", "36000 s", "constant of a magnet's temperature");

  Parameter<bool> ripple = yes("ripple", "the effort ripples along the way");
  Parameter<double> ripple_amplitude =
      number("ripple_amplitude", "%", "0.7 %", "0 %", "20 %", "of the effort");
  Parameter<double> slider_ripple_pitch = pitch("slider_ripple_pitch", "m", "25.6 mm", "1 mm");
  Parameter<double> ring_ripple_pitch = pitch("ring_ripple_pitch", "rad", "32 mrad", "1 mrad");

  Parameter<bool> cogging = yes("cogging", "magnets pull along the way, without any effort");
  Parameter<double> slider_cogging =
      number("slider_cogging", "N", "0.05 N", "0 N", "10 N", "amplitude");
  Parameter<double> ring_cogging =
      number("ring_cogging", "N m", "1 mN m", "0 N m", "0.5 N m", "amplitude");
  Parameter<double> slider_cogging_pitch = pitch("slider_cogging_pitch", "m", "12.8 mm", "1 mm");
  Parameter<double> ring_cogging_pitch = pitch("ring_cogging_pitch", "rad", "16 mrad", "1 mrad");

  Parameter<bool> quantisation = yes("quantisation", "encoders and amplifiers count in steps");
  Parameter<std::int64_t> dac_bits{
      owner,
      "dac_bits",
      {.initial = "14", .min = "4", .max = "24", .doc = "of the amplifiers, over both peaks"}};
  Parameter<double> slider_resolution =
      number("slider_resolution", "m", "2 um", "0.001 um", "1 mm", "of its encoder");
  Parameter<std::int64_t> ring_counts{
      owner,
      "ring_counts",
      {.initial = "61440", .min = "100", .max = "1e9", .doc = "of its encoder, for each turn"}};

 private:
  Parameter<double> number(const char* name, const char* unit, const char* initial, const char* min,
                           const char* max, const char* doc) {
    return declare_number(owner, name, {unit, initial, min, max, doc});
  }
  Parameter<double> pitch(const char* name, const char* unit, const char* initial,
                          const char* least) {
    return number(name, unit, initial, least, *unit == 'm' ? "1 m" : "7 rad", "of a period");
  }
  Parameter<bool> yes(const char* name, const char* doc) {
    return declare_switch(owner, name, doc);
  }
};

}  // namespace trocar
