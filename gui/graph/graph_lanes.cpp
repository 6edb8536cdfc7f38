// SPDX-License-Identifier: Apache-2.0
#include "gui/graph/graph_lanes.hpp"

#include <map>

namespace trocar::gui {
namespace {

class LaneMaker {
 public:
  explicit LaneMaker(const GraphStructure& structure) : structure_(structure) {
    made_.lanes.push_back({});
  }

  GraphLanes make() {
    for (const GraphStructure::Node& node : structure_.nodes) {
      const std::size_t thread = structure_.threads > 1 ? lane_of_thread(node.thread) : 0;
      made_.of_node.push_back(lane_of_group(thread, node.group));
    }
    return std::move(made_);
  }

 private:
  std::size_t lane_of_thread(const std::string& name) {
    const auto [known, is_new] = threads_.try_emplace(name, made_.lanes.size());
    if (is_new) add("thread " + QString::fromStdString(name), true, 0);
    return known->second;
  }

  /// A group whose parts are in several threads has a lane in each.
  std::size_t lane_of_group(std::size_t thread, std::optional<std::size_t> group) {
    if (!group) return thread;
    const auto found = groups_.find({thread, *group});
    if (found != groups_.end()) return found->second;
    const GraphStructure::Group& one = structure_.groups[*group];
    const std::size_t outer = lane_of_group(thread, one.outer);
    groups_[{thread, *group}] = made_.lanes.size();
    const bool has_type = !one.type.empty() && one.type != "group";
    add(QString::fromStdString(one.name + (has_type ? " (" + one.type + ")" : "")), false, outer);
    return made_.lanes.size() - 1;
  }

  void add(const QString& title, bool is_thread, std::size_t outer) {
    made_.lanes[outer].inner.push_back(made_.lanes.size());
    made_.lanes.push_back({title, is_thread, made_.lanes[outer].depth + 1, outer, {}});
  }

  const GraphStructure& structure_;
  GraphLanes made_;
  std::map<std::string, std::size_t> threads_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> groups_;
};

}  // namespace

bool GraphLanes::holds(std::size_t lane, std::size_t inner) const {
  while (inner != lane && inner != 0) inner = lanes[inner].outer;
  return inner == lane;
}

GraphLanes lanes_of(const GraphStructure& structure) {
  return LaneMaker(structure).make();
}

}  // namespace trocar::gui
