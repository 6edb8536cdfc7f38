// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "components/kinematics/laparoscope_geometry.hpp"

namespace trocar::gui {

/// How the laparoscope of a run is built and stands, as its device's parameters in the graph say.
struct LaparoscopeSetup {
  std::string device;  // component: "laparoscope.device"
  LaparoscopeGeometry geometry;
  LaparoscopeLimits limits;
  Eigen::Quaterniond mount = Eigen::Quaterniond::Identity();  // upright <- N
  /// [m] along the tool from E
  double tip_offset = 0.0, incision_offset = 0.0, handle_offset = 0.0;

  /// The first device whose parameters are those of a laparoscope's geometry.
  /// @param graph docs/log-format.md#graphjson
  static std::optional<LaparoscopeSetup> of(const nlohmann::json& graph);
};

}  // namespace trocar::gui
