// SPDX-License-Identifier: Apache-2.0
#include "components/register_laparoscope.hpp"

#include "components/devices/laparoscope.hpp"
#include "components/devices/simulated_laparoscope.hpp"
#include "components/kinematics/gravity_compensation.hpp"
#include "components/kinematics/laparoscope_kinematics.hpp"
#include "components/kinematics/laparoscope_statics.hpp"

namespace trocar {

void register_laparoscope(Registry& registry) {
  registry.add<Laparoscope>("Laparoscope", "devices",
                            "The laparoscopic interface with sites for fixtures, weight held");
  registry.add<SimulatedLaparoscope>("SimulatedLaparoscope", "devices",
                                     "The laparoscopic interface as a simulation");
  registry.add<LaparoscopeKinematics>("LaparoscopeKinematics", "kinematics",
                                      "Where the tool and its sites are and how they move");
  registry.add<LaparoscopeStatics>("LaparoscopeStatics", "kinematics",
                                   "Forces at the tool's sites become efforts of the axes");
  registry.add<GravityCompensation>("GravityCompensation", "kinematics",
                                    "The effort that holds the laparoscope's weight");
}

}  // namespace trocar
