// SPDX-License-Identifier: Apache-2.0
#include "gui/graph/graph_reading.hpp"

#include "gui/playback/log_feed.hpp"
#include "gui/window/page.hpp"

namespace trocar::gui {
namespace {

const GraphJson no_entry = nullptr;
const GraphJson no_list = GraphJson::array();

}  // namespace

const GraphJson& graph_of(const Sources& sources) {
  if (sources.live != nullptr) return sources.live->graph();
  if (sources.log != nullptr) return sources.log->graph();
  return no_entry;
}

std::string graph_text(const GraphJson& object, const char* key) {
  if (!object.is_object()) return "";
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

bool graph_flag(const GraphJson& object, const char* key) {
  if (!object.is_object()) return false;
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

const GraphJson& graph_list(const GraphJson& object, const char* key) {
  if (!object.is_object()) return no_list;
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? *found : no_list;
}

const GraphJson& graph_entry(const GraphJson& object, const char* list, const std::string& name) {
  for (const GraphJson& one : graph_list(object, list))
    if (graph_text(one, "name") == name) return one;
  return no_entry;
}

std::vector<double> graph_numbers(const GraphJson& node, const char* parameter) {
  std::vector<double> numbers;
  for (const GraphJson& one : graph_list(graph_entry(node, "parameters", parameter), "si"))
    if (one.is_number()) numbers.push_back(one.get<double>());
  return numbers;
}

std::string graph_source(const GraphJson& graph, const std::string& node,
                         const std::string& input) {
  for (const GraphJson& wire : graph_list(graph, "wires")) {
    if (!wire.is_object()) continue;
    const auto target = wire.find("target");
    if (target != wire.end() && graph_text(*target, "node") == node &&
        graph_text(*target, "input") == input)
      return graph_text(wire, "from");
  }
  return "";
}

}  // namespace trocar::gui
