// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "components/kinematics/laparoscope_dexterity.hpp"
#include "components/kinematics/laparoscope_reach.hpp"
#include "framework/realtime/parallel_for.hpp"

namespace trocar {

struct WorkspaceSettings {
  LaparoscopeGeometry geometry{};
  LaparoscopeLimits limits{};
  LaparoscopeEfforts efforts{};
  LaparoscopeMasses masses{};
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // in N [m/s^2]; what holds it is not spare
  std::uint64_t seed = 1;
  std::size_t shifts = 16;    // independent randomisations, 2 to 1024
  std::size_t tips = 8192;    // tried under each shift; a power of 2
  std::size_t poses = 65536;  // tried under each shift; a power of 2
  double cell = 0.020;        // edge of the map's cells [m]
};

/// Cubes over the bounds of the workspace; the axis n3 lies between cells.
struct CellGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // [m], the lowest corner
  double edge = 0.0;                                 // [m]
  std::array<std::size_t, 3> counts{};

  std::size_t size() const { return counts[0] * counts[1] * counts[2]; }
  std::size_t index(const Eigen::Vector3d& point) const;  // the nearest cell for one outside
  Eigen::Vector3d centre(std::size_t index) const;        // [m]
};

/// @throw std::invalid_argument for an edge that gives no map, or one of too many cells
CellGrid cell_grid(const LaparoscopeReach::Bounds& bounds, double edge);

/// A pose inside all limits, and what the device can do there.
struct WorkspacePose {
  Eigen::Vector3d tip;     // E [m]
  Eigen::Vector2d slopes;  // (t1/t3, t2/t3)
  double engagement;       // M [m]
  Dexterity dexterity;
};

/// What was sampled of a workspace.
struct Workspace {
  struct Tips {
    std::uint32_t tried = 0;
    std::uint32_t reached = 0;
  };

  double volume = 0.0;          // [m^3], of the tip in any orientation
  double standard_error = 0.0;  // [m^3]
  CellGrid grid{};
  std::vector<Tips> cells{};  // as `grid` counts them
  std::vector<WorkspacePose> poses{};
  std::size_t poses_tried = 0;
};

/// Samples tips evenly from the bounding cylinder, and poses evenly from that cylinder, the cone of
/// directions and the range of the ring angle, all by shifted Sobol points.
///
///   V = mean over shifts of V_k,   V_k = V_cylinder reached_k / tried
///   standard error = sqrt(sum (V_k - V)^2 / (K (K - 1)))
///
/// The work falls into fixed pieces that are put together in order: the result is the same for any
/// number of threads.
/// @throw std::invalid_argument for settings that cannot be.
Workspace sample_workspace(const WorkspaceSettings& settings, const ParallelOptions& options = {});

}  // namespace trocar
