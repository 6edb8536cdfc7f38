// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope.hpp"

#include "framework/graph.hpp"

namespace trocar {
namespace {

/// A site of the tool: all that concerns it has its name in every part.
Site site(const std::string& name, NodeId device, NodeId tool, NodeId statics) {
  return {.position = {tool, name, "position"},
          .velocity = {tool, name, "velocity"},
          .force = InputRef{statics, name + "_force"},
          .moment = InputRef{statics, name + "_moment"},
          .load = InputRef{device, name + "_load"}};
}

}  // namespace

void Laparoscope::build(GroupScope& scope) {
  const NodeId motors = scope.add("SimulatedLaparoscope", "device");
  const NodeId velocity = scope.add("Foaw", "velocity");
  const NodeId tool = scope.add("LaparoscopeKinematics", "tool");
  const NodeId weight = scope.add("GravityCompensation", "weight");
  const NodeId statics = scope.add("LaparoscopeStatics", "statics");

  for (const char* parameter : {"mount", "hand", "start", "ideal"})
    scope.forward(parameter, motors, parameter);
  scope.forward("mount", weight, "mount");

  for (const NodeId part : {velocity, tool, weight})
    scope.connect({motors, "position"}, {part, "position"});
  scope.connect({velocity, "velocity"}, {tool, "velocity"});
  scope.connect({weight, "effort"}, {motors, "hold"});
  scope.connect({tool, "jacobian"}, {statics, "jacobian"});
  scope.connect({tool, "pose", "position"}, {statics, "origin"});
  scope.connect({statics, "effort"}, {motors, "effort"});

  Exports& exports = scope.exports();
  for (const std::string name : {"tip", "incision", "handle"}) {
    scope.forward(name + "_offset", motors, name + "_offset");
    scope.forward(name + "_offset", tool, name + "_offset");
    scope.connect({tool, name, "position"}, {statics, name + "_at"});
    exports.sites[name] = site(name, motors, tool, statics);
  }
  for (const char* name : {"pose", "twist", "jacobian", "angles"})
    exports.outputs[name] = {tool, name};
  for (const char* name : {"position", "effort_sent", "effort_applied", "scale", "report_age"})
    exports.outputs[name] = {motors, name};
  exports.outputs["velocity"] = {velocity, "velocity"};
  exports.outputs["wrench"] = {statics, "wrench"};
}

}  // namespace trocar
