// SPDX-License-Identifier: Apache-2.0
#include "gui/device/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gui/graph/graph_reading.hpp"

namespace trocar::gui {
namespace {

std::string output_of(const GraphJson& node, const char* name, std::string_view type) {
  const GraphJson& output = graph_entry(node, "outputs", name);
  return graph_text(output, "type") == type ? graph_text(node, "name") + "." + name : "";
}

Eigen::Vector3d vector_of(const GraphJson& node, const char* parameter) {
  const std::vector<double> numbers = graph_numbers(node, parameter);
  return numbers.size() == 3 ? Eigen::Vector3d(numbers[0], numbers[1], numbers[2])
                             : Eigen::Vector3d::Zero();
}

/// Whatever acts on a point with a force is a fixture, a script's own law too.
std::optional<Scene::Fixture> fixture_of(const GraphJson& graph, const GraphJson& node) {
  Scene::Fixture fixture;
  fixture.name = graph_text(node, "name");
  fixture.force = output_of(node, "force", "Vector3");
  fixture.position = graph_source(graph, fixture.name, "position");
  if (fixture.force.empty() || fixture.position.empty()) return std::nullopt;
  fixture.depth = output_of(node, "depth", "double");
  if (graph_text(node, "type") == "Wall") {
    fixture.point = vector_of(node, "point");
    fixture.normal = vector_of(node, "normal");
    if (!(fixture.normal.norm() > 0.0)) return std::nullopt;
    fixture.normal.normalize();
    fixture.offset = graph_source(graph, fixture.name, "offset");
    fixture.kind = Scene::Fixture::Kind::wall;
  } else if (graph_text(node, "type") == "Spring") {
    fixture.displacement = output_of(node, "displacement", "Vector3");
    fixture.kind = Scene::Fixture::Kind::spring;
  }
  return fixture;
}

std::vector<std::string> forces_into(const GraphJson& graph, const std::string& input) {
  std::vector<std::string> forces;
  if (input.empty()) return forces;
  for (const GraphJson& wire : graph_list(graph, "wires"))
    if (graph_text(wire, "to") == input) forces.push_back(graph_text(wire, "from"));
  return forces;
}

void take_sites_of(const GraphJson& graph, const GraphJson& group, bool by_full_name,
                   Scene& scene) {
  const auto sites = group.is_object() ? group.find("sites") : group.end();
  if (!group.is_object() || sites == group.end() || !sites->is_object()) return;
  for (const auto& [name, site] : sites->items()) {
    const std::string position = graph_text(site, "position");
    if (position.empty()) continue;
    scene.sites.push_back({by_full_name ? graph_text(group, "name") + "." + name : name, position,
                           forces_into(graph, graph_text(site, "force"))});
  }
}

/// Where there is no mechanism to draw: every position that a component tells.
void take_positions_of(const GraphJson& node, Scene& scene) {
  constexpr std::size_t most = 12;  // more could not be told apart
  for (const GraphJson& output : graph_list(node, "outputs")) {
    const std::string name = graph_text(node, "name") + "." + graph_text(output, "name");
    const std::string type = graph_text(output, "type");
    const bool has_parts = type == "PointMotion" || type == "Pose";
    if (!has_parts && !(type == "Vector3" && graph_text(output, "unit") == "m")) continue;
    const std::string position = has_parts ? name + ".position" : name;
    const bool known = std::any_of(scene.sites.begin(), scene.sites.end(),
                                   [&](const auto& site) { return site.position == position; });
    if (!known && scene.sites.size() < most) scene.sites.push_back({name, position, {}});
  }
}

}  // namespace

Scene Scene::of(const GraphJson& graph) {
  Scene scene;
  scene.laparoscope = LaparoscopeSetup::of(graph);
  for (const GraphJson& node : graph_list(graph, "nodes")) {
    if (scene.wrench.empty()) scene.wrench = output_of(node, "wrench", "Wrench");
    if (scene.scale.empty() && graph_flag(node, "device"))
      scene.scale = output_of(node, "scale", "double");
    if (auto fixture = fixture_of(graph, node)) scene.fixtures.push_back(*std::move(fixture));
  }
  const GraphJson& groups = graph_list(graph, "groups");
  for (const GraphJson& group : groups) take_sites_of(graph, group, groups.size() > 1, scene);
  if (!scene.laparoscope)
    for (const GraphJson& node : graph_list(graph, "nodes")) take_positions_of(node, scene);
  return scene;
}

double newest_number(const DataStore& data, const std::string& signal) {
  const auto found = signal.empty() ? std::nullopt : data.find(signal);
  return found ? found->last() : std::numeric_limits<double>::quiet_NaN();
}

std::optional<Eigen::Vector3d> newest_vector(const DataStore& data, const std::string& signal) {
  if (signal.empty()) return std::nullopt;
  const Eigen::Vector3d vector(newest_number(data, signal + ".x"),
                               newest_number(data, signal + ".y"),
                               newest_number(data, signal + ".z"));
  if (!vector.allFinite()) return std::nullopt;
  return vector;
}

}  // namespace trocar::gui
