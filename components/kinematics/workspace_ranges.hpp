// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/kinematics/laparoscope_reach.hpp"
#include "components/kinematics/workspace.hpp"

namespace trocar {

/// How far the upright tool can be pushed along n3 at a distance from the axis, whatever the
/// direction of that translation [m]. The sliders' heights over the ball joint differ by then, and
/// each end of the stroke belongs to another slider:
///
///   range = stroke - (sqrt(L^2 - (e - rho)^2) - sqrt(L^2 - (e + rho)^2)),   e = Rb - Rp
///
/// cut by the limits on M; 0 beyond the limits on c and on the links' angle.
/// @param translation rho [m]
double insertion_range(const LaparoscopeGeometry& geometry, const LaparoscopeLimits& limits,
                       double translation);

/// The ring angle that is reached both ways at a distance from the axis, whatever its direction
/// [rad]: ring_travel - asin(rho/r), but not below 0.
double roll_range(const LaparoscopeGeometry& geometry, const LaparoscopeLimits& limits,
                  double translation);

/// The tilt that is reached in every direction, each with the centre of the star where it suits
/// best, while the ball joint is `depth` behind the ring plane [rad]; NaN where not even the
/// upright tool fits.
/// @param depth zt + zd [m]
double tilt_range(const LaparoscopeGeometry& geometry, const LaparoscopeLimits& limits,
                  double depth);

struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// The largest and smallest coordinates over all poses, the rings at theta = 0.
struct WorkspaceExtent {
  Range x, y, z;     // of the tip [m]
  Range yaw, pitch;  // alpha, beta [rad]
};

/// From the sampled poses that come closest, by random steps that shrink: each end is reached, and
/// may be a trifle short of the true one. The same for the same poses and seed.
WorkspaceExtent workspace_extent(const WorkspaceSettings& settings,
                                 const std::vector<WorkspacePose>& poses);

}  // namespace trocar
