// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_geometry.hpp"
#include "framework/parameter_set.hpp"

namespace trocar {

/// LaparoscopeLimits as parameters.
struct LaparoscopeLimitParameters {
  explicit LaparoscopeLimitParameters(ParameterSet* set) : owner(set) {}
  LaparoscopeLimits value() const;

  ParameterSet* owner;
  Parameter<double> slider_lowest = length("slider_lowest", "-310 mm", "end of the rails");
  Parameter<double> slider_highest = length("slider_highest", "-190 mm", "end of the rails");
  Parameter<double> ring_travel =
      angle("ring_travel", "240 deg", "720 deg", "of each ring, both ways");
  Parameter<double> centre_travel =
      length("centre_travel", "60 mm", "of the gimbal from the axis, below ring_radius");
  Parameter<double> tilt = angle("tilt", "45 deg", "89 deg", "of the tool from n3");
  Parameter<double> engagement_lowest =
      length("engagement_lowest", "20 mm", "of the tool between A and B");
  Parameter<double> engagement_highest =
      length("engagement_highest", "145 mm", "of the tool between A and B");
  Parameter<double> link_angle = angle("link_angle", "60 deg", "89 deg", "of a link to its rail");

 private:
  Parameter<double> length(const char* name, const char* initial, const char* doc) {
    return {owner,
            name,
            {.unit = "m", .initial = initial, .min = "-2000 mm", .max = "2000 mm", .doc = doc}};
  }
  Parameter<double> angle(const char* name, const char* initial, const char* max, const char* doc) {
    return {
        owner, name, {.unit = "rad", .initial = initial, .min = "0 deg", .max = max, .doc = doc}};
  }
};

}  // namespace trocar
