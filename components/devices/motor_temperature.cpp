// SPDX-License-Identifier: Apache-2.0
#include "components/devices/motor_temperature.hpp"

#include <cmath>

namespace trocar {

MotorTemperature::MotorTemperature(const LaparoscopeDriveSettings& s, const Imperfections& with)
    : settings_(s.thermal),
      derates_(with.derating),
      drifts_(with.gain_drift),
      continuous_(both(s.slider.continuous, s.ring.continuous)),
      spare_(both(s.slider.peak, s.ring.peak) - continuous_) {
  validate(s);
  steepness_ = 1.0 / (settings_.rise * (1.0 - settings_.derating_start));
  heating_ = settings_.rise * continuous_.cwiseProduct(continuous_).cwiseInverse();
  update();
}

void MotorTemperature::start(const Vector6d& winding, const Vector6d& magnet) RT_SAFE {
  winding_ = winding;
  magnet_ = magnet;
  update();
}

void MotorTemperature::advance(double duration, const Vector6d& effort) RT_SAFE {
  const Vector6d end = heating_.cwiseProduct(effort.cwiseProduct(effort));
  const Vector6d before = winding_;
  winding_ -= std::expm1(-duration / settings_.time) * (end - winding_);
  const Vector6d pulls = 0.5 * settings_.magnet_share * (before + winding_);
  magnet_ -= std::expm1(-duration / settings_.magnet_time) * (pulls - magnet_);
  update();
}

void MotorTemperature::update() RT_SAFE {
  const auto room = steepness_ * (settings_.rise - winding_.array());
  limit_ = continuous_.array() + spare_.array() * room.max(0.0).min(1.0);
  if (drifts_) gain_ = (1.0 - settings_.gain_loss * magnet_.array()).max(0.0);
}

Vector6d MotorTemperature::limited(const Vector6d& effort) const RT_SAFE {
  if (!derates_) return effort;
  return effort.cwiseMin(limit_).cwiseMax(-limit_);
}

}  // namespace trocar
