// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_limit_parameters.hpp"

namespace trocar {

LaparoscopeLimits LaparoscopeLimitParameters::value() const {
  return {.slider_low = *slider_lowest,
          .slider_high = *slider_highest,
          .ring_travel = *ring_travel,
          .centre_offset = *centre_travel,
          .tilt = *tilt,
          .engagement_low = *engagement_lowest,
          .engagement_high = *engagement_highest,
          .link_angle = *link_angle};
}

}  // namespace trocar
