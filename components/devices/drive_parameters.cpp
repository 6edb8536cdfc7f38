// SPDX-License-Identifier: Apache-2.0
#include "components/devices/drive_parameters.hpp"

#include <numbers>

namespace trocar {

void DriveParameters::apply(LaparoscopePlantSettings& settings) const {
  LaparoscopeDriveSettings& drive = settings.drive;
  ActuatorSettings& slider = drive.slider;
  slider.peak = *slider_peak;
  slider.continuous = *slider_continuous;
  slider.ripple_pitch = *slider_ripple_pitch;
  slider.cogging = *slider_cogging;
  slider.cogging_pitch = *slider_cogging_pitch;
  slider.resolution = *slider_resolution;
  ActuatorSettings& ring = drive.ring;
  ring.peak = *ring_peak;
  ring.continuous = *ring_continuous;
  ring.ripple_pitch = *ring_ripple_pitch;
  ring.cogging = *ring_cogging;
  ring.cogging_pitch = *ring_cogging_pitch;
  ring.resolution = 2.0 * std::numbers::pi / static_cast<double>(*ring_counts);
  drive.thermal = {.rise = *winding_rise,
                   .time = *winding_time,
                   .derating_start = *derating_start,
                   .magnet_share = *magnet_share,
                   .magnet_time = *magnet_time,
                   .gain_loss = *gain_loss};
  drive.dac_bits = static_cast<int>(*dac_bits);
  drive.gain = *drive_gain;
  drive.gain_spread = *gain_spread;
  drive.ripple = *ripple_amplitude;

  Imperfections& with = settings.imperfections;
  with.gain_error = *gain_error;
  with.gain_drift = *gain_drift;
  with.force_ripple = *ripple;
  with.cogging = *cogging;
  with.effort_quantisation = with.position_quantisation = *quantisation;
  with.derating = *thermal;
}

}  // namespace trocar
