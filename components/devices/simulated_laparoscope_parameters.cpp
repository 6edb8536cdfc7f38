// SPDX-License-Identifier: Apache-2.0
#include "components/devices/simulated_laparoscope_parameters.hpp"

#include <stdexcept>

namespace trocar {

HandSettings SimulatedHandParameters::value(HandMode mode) const {
  const double length = push_direction->eigen().norm();
  if (!(length > 1e-9))
    throw std::invalid_argument("push_direction = " + push_direction.text() +
                                ": has no length; give the way to push, e.g. {0, 0, 1}");
  HandSettings hand{
      .mode = mode, .mass = *hand_mass, .damping = *hand_damping, .stiffness = *hand_stiffness};
  hand.push = {.direction = push_direction->eigen() / length,
               .depth = *push_distance,
               .start = *push_start,
               .rise = *push_time,
               .dwell = *push_dwell};
  return hand;
}

Imperfections ImperfectionParameters::value(bool ideal) const {
  if (ideal) return Imperfections::none();
  return {.viscous_friction = *friction,
          .coulomb_friction = *friction,
          .gain_error = *gain_error,
          .force_ripple = *ripple,
          .effort_quantisation = *quantisation,
          .saturation = true,
          .position_quantisation = *quantisation,
          .homing_error = *homing_error};
}

// Errors of a model against the real thing as they are found after weighing the parts:
// m_tool -5 %, s_tool -3 %, m_sl +1 %. Here the model is nominal, so the device differs.
LaparoscopeMasses ImperfectionParameters::masses(const LaparoscopeMasses& nominal,
                                                 bool ideal) const {
  LaparoscopeMasses real = nominal;
  if (ideal || !*weight_error) return real;
  real.tool /= 0.95;
  real.tool_centre /= 0.97;
  real.slider /= 1.01;
  return real;
}

}  // namespace trocar
