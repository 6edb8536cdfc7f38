// SPDX-License-Identifier: Apache-2.0
#include "components/register.hpp"

#include "components/control/creep.hpp"
#include "components/control/delay.hpp"
#include "components/control/product.hpp"
#include "components/control/scale.hpp"
#include "components/control/sum.hpp"
#include "components/devices/generic_hid.hpp"
#include "components/filters/difference.hpp"
#include "components/filters/foaw.hpp"
#include "components/fixtures/pose_spring.hpp"
#include "components/fixtures/spring.hpp"
#include "components/fixtures/wall.hpp"
#include "components/register_laparoscope.hpp"
#include "components/sources/chirp.hpp"
#include "components/sources/constant.hpp"
#include "components/sources/sine.hpp"
#include "components/sources/staircase.hpp"
#include "components/sources/step.hpp"
#include "components/sources/tool_motion.hpp"
#include "framework/capture.hpp"
#include "framework/logger.hpp"

namespace trocar {

void register_components(Registry& registry) {
  register_laparoscope(registry);
  registry.add(generic_hid_type());

  registry.add<Creep>("Creep", "control", "Tissue that yields slowly under a load");
  registry.add<Delay>("Delay", "control", "A signal some ticks ago; breaks a loop");
  registry.add<Product>("Product", "control", "A signal times a number that varies");
  registry.add<Scale>("Scale", "control", "A signal times a fixed factor");
  registry.add<Sum>("Sum", "control", "Signals added and taken off");

  registry.add<Difference>("Difference", "filters", "Velocity as the backward difference");
  registry.add<Foaw>("Foaw", "filters", "Velocity by first-order adaptive windowing");

  registry.add<PoseSpring>("PoseSpring", "fixtures",
                           "Holds a tool's pose, or makes it follow a motion");
  registry.add<Spring>("Spring", "fixtures", "A spring-damper that pulls to a centre");
  registry.add<Wall>("Wall", "fixtures", "A flat spring-damper wall that never pulls in");

  registry.add<Capture>("Capture", "recording",
                        "Records around the moment when a signal crosses a value");
  registry.add<Logger>("Logger", "recording", "Says where a session is recorded, and what of it");

  registry.add<Chirp>("Chirp", "sources", "A sine whose frequency moves from one to another");
  registry.add<ChirpMotion>("ChirpMotion", "sources",
                            "A chirp of a point along a line, with its derivatives");
  registry.add<Constant>("Constant", "sources", "A value that stays");
  registry.add<ShuttleMotion>("ShuttleMotion", "sources", "A point to and fro at a constant speed");
  registry.add<Sine>("Sine", "sources", "A sine of one frequency");
  registry.add<Staircase>("Staircase", "sources", "A load on the tool, up and down in steps");
  registry.add<Step>("Step", "sources", "One value until a time, another from then on");
}

}  // namespace trocar
