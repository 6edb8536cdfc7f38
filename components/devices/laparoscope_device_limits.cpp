// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope_device_limits.hpp"

#include <numbers>

namespace trocar {
namespace {

struct AxisFigures {
  double effort, rise, speed, margin, damping, damping_cap, hold_tolerance;
};

// rise:    20 N at E takes up to 101 N and 6.1 N m inside the workspace: 5 ms.
// speed:   1 m/s of a tool that does not turn takes up to 2.0 m/s and 20 rad/s; at that the rings'
//          motors turn at 2900 rpm behind a capstan of 15.
// margin:  how far the peak effort presses into the rubber stops of 100 N/mm and 300 N m/rad,
//          and half as much again.
// hold_tolerance: a capped damping, and a weight known to some percent; three sliders stay below
//          the handle's cap of 20 N.
constexpr AxisFigures slider_figures{200.0, 20e3, 2.0, 3e-3, 20.0, 5.0, 6.0};
constexpr AxisFigures ring_figures{12.0, 1.2e3, 20.0, 0.06, 0.15, 0.3, 0.4};
constexpr double handle_speed = 1.0;  // [m/s], from which the speeds follow

}  // namespace

DeviceLimits laparoscope_device_limits(const LaparoscopeLimits& ranges, double period) {
  DeviceLimits limits;
  limits.axes = 6;
  limits.handle_speed = handle_speed;
  for (int i = 0; i < 6; ++i) {
    const AxisFigures& axis = i < 3 ? slider_figures : ring_figures;
    const double middle = 2.0 * std::numbers::pi / 3.0 * (i - 3);
    limits.effort[i] = axis.effort;
    limits.rise[i] = axis.rise;
    limits.speed[i] = axis.speed;
    limits.lowest[i] = i < 3 ? ranges.slider_low : middle - ranges.ring_travel;
    limits.highest[i] = i < 3 ? ranges.slider_high : middle + ranges.ring_travel;
    limits.margin[i] = axis.margin;
    // Twice the speed that trips by itself, so that only a wrong report is taken for one.
    limits.jump[i] = 2.0 * axis.speed * period;
    limits.damping[i] = axis.damping;
    limits.damping_cap[i] = axis.damping_cap;
    limits.hold_tolerance[i] = axis.hold_tolerance;
  }
  return limits;
}

}  // namespace trocar
