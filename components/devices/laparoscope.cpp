// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope.hpp"

#include <optional>
#include <vector>

#include "framework/graph.hpp"

namespace trocar {
namespace {

/// A site of the tool: all that concerns it has its name in every part.
Site site(const std::string& name, std::optional<NodeId> loaded, NodeId tool, NodeId statics) {
  Site site;
  site.position = {tool, name, "position"};
  site.velocity = {tool, name, "velocity"};
  site.force = InputRef{statics, name + "_force"};
  site.moment = InputRef{statics, name + "_moment"};
  if (loaded) site.load = InputRef{*loaded, name + "_load"};
  return site;
}

}  // namespace

void Laparoscope::build(GroupScope& scope) {
  const bool simulated = device->index == 0;
  const NodeId motors = scope.add(simulated ? "SimulatedLaparoscope" : "HidLaparoscope", "device");
  const NodeId velocity = scope.add("Foaw", "velocity");
  const NodeId tool = scope.add("LaparoscopeKinematics", "tool");
  const NodeId weight = scope.add("GravityCompensation", "weight");
  const NodeId statics = scope.add("LaparoscopeStatics", "statics");

  using Names = std::vector<const char*>;
  for (const char* parameter :
       simulated ? Names{"hand", "start", "ideal"} : Names{"serial", "path"})
    scope.forward(parameter, motors, parameter);
  scope.forward("mount", motors, "mount");
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
    exports.sites[name] =
        site(name, simulated ? std::optional(motors) : std::nullopt, tool, statics);
  }
  for (const char* name : {"pose", "twist", "jacobian", "angles"})
    exports.outputs[name] = {tool, name};
  for (const char* name : {"position", "effort_sent", "effort_applied", "scale", "report_age"})
    exports.outputs[name] = {motors, name};
  exports.outputs["velocity"] = {velocity, "velocity"};
  exports.outputs["wrench"] = {statics, "wrench"};
}

}  // namespace trocar
