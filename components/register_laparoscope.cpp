// SPDX-License-Identifier: Apache-2.0
#include "components/register_laparoscope.hpp"

#include "components/control/friction_compensation.hpp"
#include "components/control/gain_calibration.hpp"
#include "components/devices/hid_laparoscope.hpp"
#include "components/devices/laparoscope.hpp"
#include "components/devices/simulated_laparoscope.hpp"
#include "components/kinematics/gravity_compensation.hpp"
#include "components/kinematics/inertia_feed_forward.hpp"
#include "components/kinematics/laparoscope_kinematics.hpp"
#include "components/kinematics/laparoscope_statics.hpp"
#include "components/kinematics/laparoscope_workspace.hpp"
#include "components/kinematics/tool_reference.hpp"

namespace trocar {

void register_laparoscope(Registry& registry) {
  registry.add<Laparoscope>("Laparoscope", "devices",
                            "The laparoscopic interface with sites for fixtures, weight held");
  registry.add<SimulatedLaparoscope>("SimulatedLaparoscope", "devices",
                                     "The laparoscopic interface as a simulation");
  registry.add<HidLaparoscope>("HidLaparoscope", "devices", "The laparoscopic interface over USB");
  registry.add<LaparoscopeKinematics>("LaparoscopeKinematics", "kinematics",
                                      "Where the tool and its sites are and how they move");
  registry.add<LaparoscopeStatics>("LaparoscopeStatics", "kinematics",
                                   "Forces at the tool's sites become efforts of the axes");
  registry.add<GravityCompensation>("GravityCompensation", "kinematics",
                                    "The effort that holds the laparoscope's weight");
  registry.add<InertiaFeedForward>("InertiaFeedForward", "kinematics",
                                   "The effort that a known motion of the axes needs");
  registry.add<LaparoscopeWorkspace>("LaparoscopeWorkspace", "kinematics",
                                     "Where the laparoscope's tool reaches, sampled");
  registry.add<ToolReference>("ToolReference", "kinematics",
                              "The axes' motion that makes the tip follow another");
  registry.add<FrictionCompensation>("FrictionCompensation", "control",
                                     "Takes off most of the friction of the laparoscope's axes");
  registry.add<GainCalibration>("GainCalibration", "control",
                                "Commands for drives whose gain is not 1");
}

}  // namespace trocar
