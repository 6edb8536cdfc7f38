// SPDX-License-Identifier: Apache-2.0
#include "components/devices/end_stops.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "components/kinematics/three_phases.hpp"

namespace trocar {
namespace {

struct Rubber {
  double stiffness, damping;
};

void press(const Rubber& rubber, double penetration, const Vector6d& gradient, const Vector6d& v,
           EndStops::Reaction& sum) RT_SAFE {
  const double spring = rubber.stiffness * penetration;
  sum.any = true;
  sum.potential += 0.5 * spring * penetration;
  sum.effort -= spring * gradient;
  // A stop that is left faster than it springs back does not pull.
  if (spring + rubber.damping * gradient.dot(v) > 0.0)
    sum.damping += rubber.damping * gradient * gradient.transpose();
  else
    sum.effort += spring * gradient;
}

}  // namespace

EndStops::EndStops(const EndStopSettings& settings, const LaparoscopeLimits& limits,
                   const LaparoscopeGeometry& geometry)
    : settings_(settings),
      limits_(limits),
      least_link_height_(geometry.link_length * std::cos(limits.link_angle)) {
  validate(limits, geometry);
  for (const double value :
       {settings.stiffness, settings.damping, settings.angular_stiffness, settings.angular_damping})
    if (!(value >= 0.0 && std::isfinite(value)))
      throw std::invalid_argument("end stops: " + std::to_string(value) +
                                  ": stiffness and damping need finite values of at least 0");
}

EndStops::Reaction EndStops::reaction(const LaparoscopeConfiguration& c, const LaparoscopeRates& r,
                                      const Vector6d& v) const RT_SAFE {
  const Rubber length{settings_.stiffness, settings_.damping};
  const Rubber angle{settings_.angular_stiffness, settings_.angular_damping};
  Reaction sum;
  const auto between = [&](double value, double low, double high, const Rubber& rubber,
                           const auto& gradient) {
    if (value > high)
      press(rubber, value - high, gradient(), v, sum);
    else if (value < low)
      press(rubber, low - value, -gradient(), v, sum);
  };
  for (int i = 0; i < 3; ++i) {
    between(c.q[i], limits_.slider_low, limits_.slider_high, length,
            [i]() -> Vector6d { return Vector6d::Unit(i); });
    between(c.q[3 + i] - phase_angle[i], -limits_.ring_travel, limits_.ring_travel, angle,
            [i]() -> Vector6d { return Vector6d::Unit(3 + i); });
    between(c.delta.links(i, 2), least_link_height_, HUGE_VAL, length, [i, &r]() {
      Vector6d g = Vector6d::Zero();
      g.head<3>() = r.delta.jacobian.row(2);
      g[i] -= 1.0;
      return g;
    });
  }
  between(c.rings.centre.norm(), 0.0, limits_.centre_offset, length, [&]() {
    Vector6d g = Vector6d::Zero();
    g.tail<3>() = r.rings.topRows<2>().transpose() * c.rings.centre.normalized();
    return g;
  });
  const auto along_span = [&](const Eigen::Vector3d& direction) {  // d/dq of direction·(B - A)
    Vector6d g;
    g.head<3>() = -(r.delta.jacobian.transpose() * direction);
    g.tail<3>() = r.rings.topRows<2>().transpose() * direction.head<2>();
    return g;
  };
  between(c.tool.engagement, limits_.engagement_low, limits_.engagement_high, length,
          [&]() { return along_span(c.tool.axis); });
  if (c.tool.axis.z() < std::cos(limits_.tilt))
    between(c.tool.tilt(), 0.0, limits_.tilt, angle, [&]() {
      const Eigen::Vector3d steeper = -r.tool.axis.row(2).transpose() / std::sin(c.tool.tilt());
      return along_span(steeper);
    });
  return sum;
}

}  // namespace trocar
