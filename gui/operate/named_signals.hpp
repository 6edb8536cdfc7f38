// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace trocar::gui {

/// Which of a graph's signals an operator looks at first, found by what the components declare and
/// never by what one script calls them. Empty where the graph has none.
struct NamedSignals {
  std::string device;       // component: "laparoscope.device"
  std::string device_type;  // "SimulatedLaparoscope"
  bool simulated = false;   // it knows the truth of its plant, which only a simulation does
  double force_cap = 0.0;   // [N] at the handle; 0: not declared
  double moment_cap = 0.0;  // [N m]

  std::string wrench;        // at the tool that is asked for: "laparoscope.statics.wrench"
  std::string origin;        // position, about which that wrench's moment is taken
  std::string handle;        // position
  std::string tip;           // position: "laparoscope.tool.tip.position"
  std::string applied;       // effort, the device's echo
  std::string hold;          // of it what only bears the device's weight
  std::string scale;         // share of effort that the gate let pass
  std::string report_age;    // of the device
  std::string device_state;  // of a device that has states of its own
  std::vector<std::string> device_states;  // their labels
  std::string dead_man;

  struct Fixture {
    std::string name;   // component
    std::string force;  // "wall.force"
    std::string depth;  // "" where it has none
  };
  std::vector<Fixture> fixtures;

  /// @param graph docs/log-format.md#graphjson; what is not as it says is passed over
  static NamedSignals of(const nlohmann::json& graph);
};

}  // namespace trocar::gui
