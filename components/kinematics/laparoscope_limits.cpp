// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_limits.hpp"

#include <cmath>

#include "components/kinematics/three_phases.hpp"

namespace trocar {

const char* LimitSet::name(unsigned limit) RT_SAFE {
  static constexpr const char* names[] = {
      "slider_1_low",    "slider_2_low", "slider_3_low",  "slider_1_high", "slider_2_high",
      "slider_3_high",   "ring_1_low",   "ring_2_low",    "ring_3_low",    "ring_1_high",
      "ring_2_high",     "ring_3_high",  "centre_offset", "tilt",          "engagement_low",
      "engagement_high", "link_1_angle", "link_2_angle",  "link_3_angle"};
  static_assert(sizeof(names) / sizeof(names[0]) == count);
  return limit < count ? names[limit] : "unknown";
}

LimitSet violated_limits(const LaparoscopeLimits& limits,
                         const LaparoscopeConfiguration& c) RT_SAFE {
  LimitSet set;
  // Written so that a NaN violates.
  const auto at_most = [&set](double value, double limit, unsigned which) {
    set.add_if(!(value <= limit + limit_tolerance), which);
  };
  for (unsigned i = 0; i < 3; ++i) {
    const double slider = c.q[i];
    const double ring = c.q[3 + i] - phase_angle[i];
    const Eigen::Vector3d link = c.delta.links.row(i);
    at_most(-slider, -limits.slider_low, LimitSet::slider_1_low + i);
    at_most(slider, limits.slider_high, LimitSet::slider_1_high + i);
    at_most(-ring, limits.ring_travel, LimitSet::ring_1_low + i);
    at_most(ring, limits.ring_travel, LimitSet::ring_1_high + i);
    at_most(std::atan2(link.head<2>().norm(), link.z()), limits.link_angle,
            LimitSet::link_1_angle + i);
  }
  at_most(c.rings.centre.norm(), limits.centre_offset, LimitSet::centre_offset);
  at_most(c.tool.tilt(), limits.tilt, LimitSet::tilt);
  at_most(-c.tool.engagement, -limits.engagement_low, LimitSet::engagement_low);
  at_most(c.tool.engagement, limits.engagement_high, LimitSet::engagement_high);
  return set;
}

bool reachable(const LaparoscopeModel& model, const LaparoscopeLimits& limits,
               const PoseCoordinates& pose) RT_SAFE {
  Vector6d q;
  LaparoscopeConfiguration c;
  return model.inverse(pose, q) == AssemblyStatus::ok &&
         model.forward(q, c) == AssemblyStatus::ok && violated_limits(limits, c).empty();
}

}  // namespace trocar
