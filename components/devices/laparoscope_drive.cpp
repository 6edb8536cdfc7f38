// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope_drive.hpp"

#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "components/devices/seeded_random.hpp"

namespace trocar {
namespace {

void require(bool holds, const char* what, double value, const char* allowed) {
  if (holds) return;
  std::ostringstream text;
  text << "drive: " << what << " = " << value << ": needs " << allowed;
  throw std::invalid_argument(text.str());
}

void validate(const ActuatorSettings& a) {
  require(a.peak > 0.0, "peak", a.peak, "an effort above 0, e.g. 200 N");
  require(a.viscous >= 0.0, "viscous", a.viscous, "a value of at least 0");
  require(a.coulomb >= 0.0, "coulomb", a.coulomb, "a value of at least 0");
  require(a.ripple_pitch > 0.0, "ripple_pitch", a.ripple_pitch, "a value above 0");
  require(a.resolution > 0.0, "resolution", a.resolution, "a value above 0, e.g. 2e-6 m");
  require(a.homing_low >= 0.0, "homing_low", a.homing_low, "a value of at least 0");
  require(a.homing_high >= a.homing_low, "homing_high", a.homing_high,
          "at least the value of homing_low");
}

Vector6d both(double slider, double ring) {
  return (Vector6d() << slider, slider, slider, ring, ring, ring).finished();
}

/// Rounds to the nearest step, ties to even, as a converter without hysteresis.
double to_step(double value, double step) RT_SAFE {
  return std::nearbyint(value / step) * step;
}

}  // namespace

LaparoscopeDrive::LaparoscopeDrive(const LaparoscopeDriveSettings& s, const Imperfections& with,
                                   std::uint64_t seed)
    : imperfections_(with), ripple_(with.force_ripple ? s.ripple : 0.0) {
  validate(s.slider);
  validate(s.ring);
  require(s.dac_bits >= 2 && s.dac_bits <= 32, "dac_bits", s.dac_bits, "2 to 32 bits");
  require(s.gain > 0.0, "gain", s.gain, "a value above 0, e.g. 0.9655");
  require(s.gain_spread >= 0.0 && s.gain_spread < s.gain, "gain_spread", s.gain_spread,
          "a value of at least 0 and below gain");
  require(s.ripple >= 0.0 && s.ripple < 1.0, "ripple", s.ripple, "a value from 0 to below 1");

  peak_ = both(s.slider.peak, s.ring.peak);
  dac_step_ = peak_ / std::ldexp(1.0, s.dac_bits - 1);
  viscous_ = with.viscous_friction ? both(s.slider.viscous, s.ring.viscous) : Vector6d::Zero();
  coulomb_ = with.coulomb_friction ? both(s.slider.coulomb, s.ring.coulomb) : Vector6d::Zero();
  wave_number_ =
      2.0 * std::numbers::pi * both(s.slider.ripple_pitch, s.ring.ripple_pitch).cwiseInverse();
  resolution_ = both(s.slider.resolution, s.ring.resolution);

  // Always drawn in this order: switching one imperfection off leaves the others as they are.
  SeededRandom random(seed);
  for (int i = 0; i < 6; ++i) {
    const ActuatorSettings& a = i < 3 ? s.slider : s.ring;
    gain_[i] = random.uniform(s.gain - s.gain_spread, s.gain + s.gain_spread);
    phase_[i] = random.uniform(0.0, 2.0 * std::numbers::pi);
    homing_[i] = random.signed_uniform(a.homing_low, a.homing_high);
  }
  if (!with.gain_error) gain_.setOnes();
  if (!with.homing_error) homing_.setZero();
}

Vector6d LaparoscopeDrive::sent(const Vector6d& command) const RT_SAFE {
  Vector6d out;
  for (int i = 0; i < 6; ++i) {
    double u = std::isnan(command[i]) ? 0.0 : command[i];
    if (imperfections_.effort_quantisation) u = to_step(u, dac_step_[i]);
    if (imperfections_.saturation) u = std::fmin(std::fmax(u, -peak_[i]), peak_[i]);
    out[i] = u;
  }
  return out;
}

Vector6d LaparoscopeDrive::effort(const Vector6d& sent, const Vector6d& q) const RT_SAFE {
  Vector6d out = gain_.cwiseProduct(sent);
  if (ripple_ == 0.0) return out;
  for (int i = 0; i < 6; ++i)
    out[i] *= 1.0 + ripple_ * std::sin(wave_number_[i] * q[i] + phase_[i]);
  return out;
}

Vector6d LaparoscopeDrive::read(const Vector6d& q) const RT_SAFE {
  Vector6d out = q + homing_;
  if (!imperfections_.position_quantisation) return out;
  for (int i = 0; i < 6; ++i) out[i] = to_step(out[i], resolution_[i]);
  return out;
}

}  // namespace trocar
