// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "components/kinematics/workspace_map.hpp"
#include "framework/parameter.hpp"

namespace trocar::cli {

/// All that `trocar workspace` tells.
struct WorkspaceReport {
  struct AtTranslation {
    double translation;  // from the axis [m]
    double insertion;    // of the upright tool [m]
    double roll;         // either way [rad]
  };
  struct AtDepth {
    double depth;  // of the ball joint behind the ring plane [m]
    double tilt;   // [rad]
  };

  WorkspaceSettings settings{};
  bool with_weight = false;
  Workspace sampled{};
  WorkspaceExtent extent{};
  std::vector<AtTranslation> translations{};
  std::vector<AtDepth> depths{};
  std::vector<EngagementBand> engagement{};
  std::vector<WorkspaceCell> cells{};
};

WorkspaceReport workspace_report(const WorkspaceSettings& settings, const ParallelOptions& options);

/// For a reader, in mm and degrees; the map turned into one plane.
std::string workspace_text(const WorkspaceReport& report);
/// For programs, in SI. @param parameters that the settings came from
nlohmann::ordered_json workspace_json(const WorkspaceReport& report,
                                      const std::vector<ParameterBase*>& parameters);
/// The map: x,y,z of a cell's centre, the share of it that is reached, the number of poses, and of
/// each figure the least, the median and the greatest, in SI.
std::string workspace_csv(const WorkspaceReport& report);

}  // namespace trocar::cli
