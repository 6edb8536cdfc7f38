// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <QString>
#include <vector>

#include "gui/device/mechanism_pose.hpp"
#include "gui/device/workspace_outline.hpp"

namespace trocar::gui {

/// What is drawn of a device, in space [m]: lines, dots, sheets and texts in N, with what each of
/// them is. How that looks is the view's.
struct MechanismPicture {
  enum class Part {
    base,
    rail,
    carriage,
    rod,
    platform,
    ring,
    spoke,
    gimbal,
    tool,
    site,
    wall,
    spring,
    force,
    workspace,
    point,  // where there is no mechanism
  };
  struct Line {
    Eigen::Vector3d from, to;
    Part part;
  };
  struct Dot {
    Eigen::Vector3d at;
    Part part;
  };
  struct Sheet {
    std::vector<Eigen::Vector3d> corners;
    Part part;
  };
  struct Label {
    Eigen::Vector3d at;
    QString text;
    Part part;
  };

  std::vector<Line> lines{};
  std::vector<Dot> dots{};
  std::vector<Sheet> sheets{};
  std::vector<Label> labels{};

  static constexpr double force_scale = 0.008;  // [m/N] length of a force's arrow

  /// @param workspace that is drawn too, null: none
  static MechanismPicture of(const Scene& scene, const MechanismPose& pose,
                             const WorkspaceOutline* workspace = nullptr);
  /// Points that a view holds in sight, whatever the pose: it must not jump while the tool moves.
  static std::vector<Eigen::Vector3d> extent(const Scene& scene, const MechanismPose& pose);
};

}  // namespace trocar::gui
