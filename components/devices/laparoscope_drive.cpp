// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope_drive.hpp"

#include <cmath>

#include "components/devices/seeded_random.hpp"

namespace trocar {
namespace {

/// Rounds to the nearest step, ties to even, as a converter without hysteresis.
double to_step(double value, double step) RT_SAFE {
  return std::nearbyint(value / step) * step;
}

const LaparoscopeDriveSettings& valid(const LaparoscopeDriveSettings& settings) {
  validate(settings);
  return settings;
}

}  // namespace

// Always all, in this order: switching one imperfection off leaves the others as they are.
LaparoscopeDrive::Draw LaparoscopeDrive::draw(const LaparoscopeDriveSettings& s,
                                              std::uint64_t seed) {
  SeededRandom random(seed);
  Draw drawn;
  const auto phase = [&random] { return random.uniform(0.0, 1.0); };
  for (int i = 0; i < 6; ++i) {
    const ActuatorSettings& a = i < 3 ? s.slider : s.ring;
    drawn.gain[i] = random.uniform(s.gain - s.gain_spread, s.gain + s.gain_spread);
    drawn.ripple_phase[i] = phase();
    drawn.homing[i] = random.signed_uniform(a.homing_low, a.homing_high);
  }
  for (int i = 0; i < 6; ++i) drawn.cogging_phase[i] = phase();
  return drawn;
}

LaparoscopeDrive::LaparoscopeDrive(const LaparoscopeDriveSettings& s, const Imperfections& with,
                                   std::uint64_t seed)
    : LaparoscopeDrive(s, with, draw(valid(s), seed)) {}

LaparoscopeDrive::LaparoscopeDrive(const LaparoscopeDriveSettings& s, const Imperfections& with,
                                   const Draw& drawn)
    : imperfections_(with),
      ripple_(with.force_ripple ? s.ripple : 0.0),
      peak_(both(s.slider.peak, s.ring.peak)),
      dac_step_(peak_ / std::ldexp(1.0, s.dac_bits - 1)),
      viscous_(both(s.slider.viscous, s.ring.viscous)),
      gain_(drawn.gain),
      cogging_(both(s.slider.cogging, s.ring.cogging)),
      resolution_(both(s.slider.resolution, s.ring.resolution)),
      homing_(drawn.homing),
      dry_friction_(with.coulomb_friction ? both(s.slider.coulomb, s.ring.coulomb)
                                          : Vector6d(Vector6d::Zero()),
                    with.stribeck ? s.static_friction : 1.0,
                    both(s.slider.stribeck_speed, s.ring.stribeck_speed)),
      ripple_wave_(both(s.slider.ripple_pitch, s.ring.ripple_pitch), drawn.ripple_phase),
      cogging_wave_(both(s.slider.cogging_pitch, s.ring.cogging_pitch), drawn.cogging_phase) {
  if (!with.viscous_friction) viscous_.setZero();
  if (!with.gain_error) gain_.setOnes();
  if (!with.cogging) cogging_.setZero();
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
  if (ripple_ != 0.0) out.array() *= 1.0 + ripple_ * ripple_wave_.at(q).array();
  if (imperfections_.cogging) out += cogging_.cwiseProduct(cogging_wave_.at(q));
  return out;
}

Vector6d LaparoscopeDrive::read(const Vector6d& q) const RT_SAFE {
  Vector6d out = q + homing_;
  if (!imperfections_.position_quantisation) return out;
  for (int i = 0; i < 6; ++i) out[i] = to_step(out[i], resolution_[i]);
  return out;
}

}  // namespace trocar
