// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/workspace_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trocar {
namespace {

using Poses = std::vector<const WorkspacePose*>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Spread spread_over(const Poses& poses, double Dexterity::*figure) {
  std::vector<double> numbers;
  numbers.reserve(poses.size());
  for (const WorkspacePose* pose : poses) numbers.push_back(pose->dexterity.*figure);
  return spread_of(std::move(numbers));
}

}  // namespace

Spread spread_of(std::vector<double> numbers) {
  if (numbers.empty()) return {nan, nan, nan};
  std::sort(numbers.begin(), numbers.end());
  const std::size_t half = numbers.size() / 2;
  const double median =
      numbers.size() % 2 == 1 ? numbers[half] : 0.5 * (numbers[half - 1] + numbers[half]);
  return {numbers.front(), median, numbers.back()};
}

DexteritySpread dexterity_spread(const Poses& poses) {
  return {.poses = poses.size(),
          .condition = spread_over(poses, &Dexterity::condition),
          .manipulability = spread_over(poses, &Dexterity::manipulability),
          .peak_force = spread_over(poses, &Dexterity::peak_force),
          .continuous_force = spread_over(poses, &Dexterity::continuous_force)};
}

std::vector<WorkspaceCell> workspace_map(const Workspace& workspace) {
  std::vector<Poses> poses(workspace.grid.size());
  for (const WorkspacePose& pose : workspace.poses)
    poses[workspace.grid.index(pose.tip)].push_back(&pose);
  std::vector<WorkspaceCell> cells;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Workspace::Tips& tips = workspace.cells[i];
    if (tips.reached == 0 && poses[i].empty()) continue;
    const double filled = tips.tried == 0 ? nan : 1.0 * tips.reached / tips.tried;
    cells.push_back({workspace.grid.centre(i), filled, dexterity_spread(poses[i])});
  }
  return cells;
}

std::vector<EngagementBand> by_engagement(const std::vector<WorkspacePose>& poses,
                                          const LaparoscopeLimits& limits, double width) {
  const double span = limits.engagement_high - limits.engagement_low;
  const auto count = static_cast<std::size_t>(std::ceil(span / width - 1e-9));
  std::vector<Poses> members(count);
  for (const WorkspacePose& pose : poses) {
    const double at = std::max(0.0, std::floor((pose.engagement - limits.engagement_low) / width));
    members[std::min(static_cast<std::size_t>(at), count - 1)].push_back(&pose);
  }
  std::vector<EngagementBand> bands;
  for (std::size_t i = 0; i < count; ++i) {
    const double low = limits.engagement_low + width * static_cast<double>(i);
    bands.push_back(
        {{low, std::min(low + width, limits.engagement_high)}, dexterity_spread(members[i])});
  }
  return bands;
}

WorkspaceProfile workspace_profile(const std::vector<WorkspacePose>& poses, double edge) {
  WorkspaceProfile profile{.edge = edge, .low = 0.0, .rows = {}};
  if (poses.empty()) return profile;
  const auto step_of = [&](double length) { return std::floor(length / edge); };
  double first = step_of(poses.front().tip.z()), last = first, farthest = 0.0;
  for (const WorkspacePose& pose : poses) {
    first = std::min(first, step_of(pose.tip.z()));
    last = std::max(last, step_of(pose.tip.z()));
    farthest = std::max(farthest, step_of(pose.tip.head<2>().norm()));
  }
  profile.low = first * edge;
  const auto columns = static_cast<std::size_t>(farthest) + 1;
  std::vector<std::vector<Poses>> members(static_cast<std::size_t>(last - first) + 1,
                                          std::vector<Poses>(columns));
  for (const WorkspacePose& pose : poses)
    members[static_cast<std::size_t>(step_of(pose.tip.z()) - first)]
           [static_cast<std::size_t>(step_of(pose.tip.head<2>().norm()))]
               .push_back(&pose);
  for (const std::vector<Poses>& row : members) {
    profile.rows.emplace_back();
    for (const Poses& square : row) profile.rows.back().push_back(dexterity_spread(square));
  }
  return profile;
}

}  // namespace trocar
