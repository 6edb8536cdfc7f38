// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "components/kinematics/laparoscope_limits.hpp"
#include "gui/device/scene.hpp"

namespace trocar::gui {

/// The mechanism and what touches it as of the newest row that is shown, in N. Kinematics are the
/// LaparoscopeModel's.
struct MechanismPose {
  struct Fixture {
    std::size_t index = 0;                  // of Scene::fixtures
    std::optional<Eigen::Vector3d> at;      // [m] the point that it acts on
    std::optional<Eigen::Vector3d> force;   // [N] on that point
    std::optional<Eigen::Vector3d> centre;  // [m] of a spring
    double depth = 0.0;                     // [m] inside, NaN where it has none
    double offset = 0.0;                    // [m] of a wall's surface
  };

  /// The joints' positions have come, and the mechanism can be put together there.
  bool assembled = false;
  QString trouble;  // why it is not
  LaparoscopeConfiguration mechanism;
  LimitSet violated;
  std::optional<Eigen::Vector3d> force;               // [N] at E, what the gate lets through
  std::vector<std::optional<Eigen::Vector3d>> sites;  // [m] as Scene::sites
  std::vector<Fixture> fixtures;

  static MechanismPose of(const Scene& scene, const DataStore& data);
  /// In words, with units, for who does not see the picture.
  QString description(const Scene& scene) const;
};

/// "x 0.8, y 0.1, z 108.7 mm"
QString text_of_point(const Eigen::Vector3d& point);

}  // namespace trocar::gui
