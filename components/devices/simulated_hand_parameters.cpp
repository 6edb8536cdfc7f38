// SPDX-License-Identifier: Apache-2.0
#include "components/devices/simulated_hand_parameters.hpp"

#include <stdexcept>

namespace trocar {

HandSettings SimulatedHandParameters::value(HandMode mode) const {
  const double length = push_direction->eigen().norm();
  if (!(length > 1e-9))
    throw std::invalid_argument("push_direction = " + push_direction.text() +
                                ": has no length; give the way to push, e.g. {0, 0, 1}");
  HandSettings hand{.mode = mode,
                    .relaxed_grip = *relaxed_grip,
                    .mass = *hand_mass,
                    .damping = *hand_damping,
                    .stiffness = *hand_stiffness,
                    .rotational_damping = *hand_rotational_damping,
                    .rotational_stiffness = *hand_rotational_stiffness};
  hand.push = {.direction = push_direction->eigen() / length,
               .bow = push_bow->eigen(),
               .depth = *push_distance,
               .start = *push_start,
               .rise = *push_time,
               .dwell = *push_dwell};
  return hand;
}

}  // namespace trocar
