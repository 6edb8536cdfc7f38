// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_geometry.hpp"

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "components/requirement.hpp"

namespace trocar {
namespace {

std::string metres(const char* text, double bound, const char* cure) {
  std::ostringstream out;
  out << text << " = " << bound << " m; " << cure;
  return out.str();
}

}  // namespace

void validate(const LaparoscopeGeometry& g) {
  require(g.tool_length > 0.0 && std::isfinite(g.tool_length), "geometry: tool_length",
          g.tool_length, "needs a length above 0 m, e.g. 0.150");
  require(std::isfinite(g.ring_plane), "geometry: ring_plane", g.ring_plane,
          "needs a finite height in m, e.g. 0.020");
  require(g.ring_radius > 0.0 && std::isfinite(g.ring_radius), "geometry: ring_radius",
          g.ring_radius, "needs a radius above 0 m, e.g. 0.090");
  require(g.platform_radius >= 0.0 && std::isfinite(g.platform_radius), "geometry: platform_radius",
          g.platform_radius, "needs a radius of at least 0 m, e.g. 0.040");
  require(g.base_radius > g.platform_radius && std::isfinite(g.base_radius),
          "geometry: base_radius", g.base_radius,
          metres("must exceed platform_radius", g.platform_radius, "widen the base, e.g. 0.140"));
  const double e = g.base_radius - g.platform_radius;
  require(g.link_length > e && std::isfinite(g.link_length), "geometry: link_length", g.link_length,
          metres("must exceed base_radius - platform_radius", e, "lengthen the links, e.g. 0.210"));
}

void validate(const LaparoscopeMasses& m) {
  const auto mass = [](double value, const char* what) {
    require(value >= 0.0 && std::isfinite(value), what, value, "needs a value of at least 0");
  };
  mass(m.slider, "masses: slider");
  mass(m.link_pair, "masses: link_pair");
  mass(m.platform, "masses: platform");
  mass(m.tool, "masses: tool");
  mass(m.tool_transverse, "masses: tool_transverse");
  mass(m.tool_axial, "masses: tool_axial");
  mass(m.end_effector, "masses: end_effector");
  mass(m.end_effector_spin, "masses: end_effector_spin");
  mass(m.pin, "masses: pin");
  mass(m.ring, "masses: ring");
  require(std::isfinite(m.tool_centre), "masses: tool_centre", m.tool_centre,
          "needs a finite distance in m, e.g. 0.105");
}

void validate(const LaparoscopeLimits& l, const LaparoscopeGeometry& g) {
  require(l.slider_low < l.slider_high, "limits: slider_low", l.slider_low,
          metres("must be below slider_high", l.slider_high, "swap the two"));
  require(l.ring_travel > 0.0, "limits: ring_travel", l.ring_travel,
          "needs an angle above 0 rad, e.g. 4.19");
  require(l.centre_offset > 0.0 && l.centre_offset < g.ring_radius, "limits: centre_offset",
          l.centre_offset,
          metres("must lie above 0 and below ring_radius", g.ring_radius, "e.g. 0.060"));
  require(l.tilt > 0.0 && l.tilt < std::numbers::pi / 2, "limits: tilt", l.tilt,
          "must lie between 0 and 1.57 rad, e.g. 0.785");
  require(l.engagement_low > 0.0, "limits: engagement_low", l.engagement_low,
          "must exceed 0 m, e.g. 0.020");
  require(l.engagement_high > l.engagement_low && l.engagement_high <= g.tool_length,
          "limits: engagement_high", l.engagement_high,
          metres("must lie above engagement_low and not exceed tool_length", g.tool_length,
                 "e.g. 0.145"));
  require(l.link_angle > 0.0 && l.link_angle < std::numbers::pi / 2, "limits: link_angle",
          l.link_angle, "must lie between 0 and 1.57 rad, e.g. 1.047");
}

}  // namespace trocar
