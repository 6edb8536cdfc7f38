// SPDX-License-Identifier: Apache-2.0
#include "gui/device/laparoscope_setup.hpp"

#include <algorithm>
#include <stdexcept>

#include "components/kinematics/laparoscope_limit_parameters.hpp"
#include "components/kinematics/laparoscope_parameters.hpp"
#include "gui/graph/graph_reading.hpp"

namespace trocar::gui {
namespace {

/// The device's own declarations, so that a value means here what it means there.
struct LaparoscopeDeclarations : ParameterSet {
  LaparoscopeGeometryParameters geometry{this};
  LaparoscopeLimitParameters limits{this};
  LaparoscopeSiteParameters sites{this};
  MountParameter mount{this};

  void take(const GraphJson& parameter) {
    ParameterBase* own = find_parameter(graph_text(parameter, "name"));
    if (own == nullptr) return;
    own->set(literal_from_text(graph_text(parameter, "value")));
    const GraphJson& numbers = graph_list(parameter, "si");  // exact, where the text is rounded
    const std::span<double> values = own->numbers();
    for (std::size_t i = 0; i < std::min(values.size(), numbers.size()); ++i)
      if (numbers[i].is_number()) values[i] = numbers[i].get<double>();
  }
};

bool is_laparoscope(const GraphJson& node) {
  const char* of_geometry[] = {"tool_length", "ring_plane",      "ring_radius",
                               "base_radius", "platform_radius", "link_length"};
  return graph_flag(node, "device") &&
         std::all_of(std::begin(of_geometry), std::end(of_geometry),
                     [&](const char* name) { return graph_numbers(node, name).size() == 1; }) &&
         graph_text(graph_entry(node, "outputs", "position"), "type") == "Joints";
}

}  // namespace

std::optional<LaparoscopeSetup> LaparoscopeSetup::of(const GraphJson& graph) {
  for (const GraphJson& node : graph_list(graph, "nodes")) {
    if (!is_laparoscope(node)) continue;
    LaparoscopeDeclarations declared;
    for (const GraphJson& parameter : graph_list(node, "parameters")) declared.take(parameter);
    LaparoscopeSetup setup{.device = graph_text(node, "name"),
                           .geometry = declared.geometry.value(),
                           .limits = declared.limits.value(),
                           .mount = declared.mount.mount->eigen(),
                           .tip_offset = *declared.sites.tip_offset,
                           .incision_offset = *declared.sites.incision_offset,
                           .handle_offset = *declared.sites.handle_offset};
    try {
      validate(setup.geometry);
      validate(setup.limits, setup.geometry);
    } catch (const std::invalid_argument&) {
      continue;  // no device that could run
    }
    return setup;
  }
  return std::nullopt;
}

}  // namespace trocar::gui
