// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_workspace.hpp"

#include <algorithm>

#include "components/kinematics/workspace.hpp"
#include "components/kinematics/workspace_ranges.hpp"

namespace trocar {

void LaparoscopeWorkspace::configure(const Setup&) {
  WorkspaceSettings settings;
  settings.geometry = geometry.value();
  settings.limits = limits.value();
  settings.seed = static_cast<std::uint64_t>(*seed);
  settings.tips = static_cast<std::size_t>(*tips);
  settings.poses = static_cast<std::size_t>(*poses);
  const Workspace sampled = sample_workspace(settings);
  const WorkspaceExtent extent = workspace_extent(settings, sampled.poses);
  *volume = sampled.volume;
  *standard_error = sampled.standard_error;
  *lowest = {extent.x.low, extent.y.low, extent.z.low};
  *highest = {extent.x.high, extent.y.high, extent.z.high};
  *yaw = std::min(extent.yaw.high, -extent.yaw.low);
  *pitch = std::min(extent.pitch.high, -extent.pitch.low);
  *insertion = insertion_range(settings.geometry, settings.limits, *translation);
  *roll = roll_range(settings.geometry, settings.limits, *translation);
  *tilt = tilt_range(settings.geometry, settings.limits, *depth);
}

void LaparoscopeWorkspace::step(const Tick&) RT_SAFE {}

}  // namespace trocar
