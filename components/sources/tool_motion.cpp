// SPDX-License-Identifier: Apache-2.0
#include "components/sources/tool_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace trocar {

using std::numbers::pi;

MotionPoint sweep_motion(const LinearSweep& s, double t) RT_SAFE {
  if (!(t >= 0.0 && t < s.duration)) return {};
  double w = 1.0, w1 = 0.0, w2 = 0.0;  // window and its derivatives
  const double edge = std::min(t, s.duration - t);
  if (edge < s.taper) {
    const double k = pi / s.taper;
    w = 0.5 * (1.0 - std::cos(k * edge));
    w1 = 0.5 * k * std::sin(k * edge) * (2.0 * t < s.duration ? 1.0 : -1.0);
    w2 = 0.5 * k * k * std::cos(k * edge);
  }
  const double growth = (s.to - s.from) / s.duration;
  const double phase = 2.0 * pi * (s.from * t + 0.5 * growth * t * t);
  const double phase1 = 2.0 * pi * (s.from + growth * t);
  const double phase2 = 2.0 * pi * growth;
  const double sine = std::sin(phase), cosine = std::cos(phase);
  return {s.amplitude * w * sine, s.amplitude * (w1 * sine + w * phase1 * cosine),
          s.amplitude * (w2 * sine + 2.0 * w1 * phase1 * cosine +
                         w * (phase2 * cosine - phase1 * phase1 * sine))};
}

MotionPoint Shuttle::at(double t) const RT_SAFE {
  const double start = speed / acceleration;  // [s] from rest to the speed
  if (!(t >= 0.0)) return {};
  if (t < start) return {0.5 * acceleration * t * t, acceleration * t, acceleration};
  const double run_up = 0.5 * speed * start;
  const double way = stroke / speed, turn = 2.0 * start;
  double s = std::fmod(t - start, 2.0 * (way + turn));
  double sign = 1.0;
  if (s >= way + turn) {
    s -= way + turn;
    sign = -1.0;
  }
  const double from = sign > 0.0 ? run_up : run_up + stroke;
  if (s < way) return {from + sign * speed * s, sign * speed, 0.0, true};
  const double u = s - way;
  return {from + sign * (stroke + speed * u - 0.5 * acceleration * u * u),
          sign * (speed - acceleration * u), -sign * acceleration};
}

void ToolMotion::step(const Tick& tick) RT_SAFE {
  const MotionPoint point = at(tick.time + *lead - *begin);
  const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis->index);
  *offset = Eigen::Vector3d(point.offset * along);
  *velocity = Eigen::Vector3d(point.velocity * along);
  *acceleration = Eigen::Vector3d(point.acceleration * along);
  *steady = point.steady;
}

void ChirpMotion::configure(const Setup&) {
  if (!(2.0 * *taper <= *duration))
    throw std::invalid_argument(fmt::format("taper = \"{}\": at most half the duration, {:.6g} s",
                                            taper.text(), 0.5 * *duration));
  sweep_ = {*amplitude, *from, *to, *duration, *taper};
}

MotionPoint ChirpMotion::at(double t) const RT_SAFE {
  return sweep_motion(sweep_, t);
}

void ShuttleMotion::configure(const Setup&) {
  shuttle_ = {*stroke, *speed, *turning};
}

MotionPoint ShuttleMotion::at(double t) const RT_SAFE {
  return shuttle_.at(t);
}

}  // namespace trocar
