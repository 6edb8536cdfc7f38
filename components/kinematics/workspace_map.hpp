// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/kinematics/workspace.hpp"
#include "components/kinematics/workspace_ranges.hpp"

namespace trocar {

/// Of some numbers; NaN for none.
struct Spread {
  double least;
  double median;
  double greatest;
};
Spread spread_of(std::vector<double> numbers);

/// What the device can do in a part of its workspace: over the sampled poses there.
struct DexteritySpread {
  std::size_t poses = 0;
  Spread condition;
  Spread manipulability;
  Spread peak_force;        // [N]
  Spread continuous_force;  // [N]
};
DexteritySpread dexterity_spread(const std::vector<const WorkspacePose*>& poses);

/// One cell of the map.
struct WorkspaceCell {
  Eigen::Vector3d centre;  // [m]
  double filled = 0.0;     // share of the tips tried there that are reachable; NaN without any
  DexteritySpread dexterity;
};
/// The cells in which a tip was reached or a pose lies, x fastest.
std::vector<WorkspaceCell> workspace_map(const Workspace& workspace);

/// The poses whose engagement lies in a range [m].
struct EngagementBand {
  Range engagement;
  DexteritySpread dexterity;
};
/// @param width of the bands [m]
std::vector<EngagementBand> by_engagement(const std::vector<WorkspacePose>& poses,
                                          const LaparoscopeLimits& limits, double width);

/// The map turned about n3 into one plane: rows by height, columns by distance from the axis.
struct WorkspaceProfile {
  double edge = 0.0;                               // of its squares [m]
  double low = 0.0;                                // height at which row 0 begins [m]
  std::vector<std::vector<DexteritySpread>> rows;  // all of the same length
};
WorkspaceProfile workspace_profile(const std::vector<WorkspacePose>& poses, double edge);

}  // namespace trocar
