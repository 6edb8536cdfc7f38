// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gui/data/cell_table.hpp"
#include "gui/device/mechanism_pose.hpp"

namespace trocar::gui {

/// The axes of a graph's first device, and which signals tell of them.
struct JointSignals {
  std::string device;
  std::vector<std::string> units;                              // of positions, one for each axis
  std::vector<std::string> effort_units;                       // likewise
  std::string position, velocity, asked, hold, sent, applied;  // "" where there is none

  static JointSignals of(const nlohmann::json& graph);
};

/// Tables of numbers, with their units, as of the newest row that is shown.
QStringList joint_header();
std::vector<CellTable::Row> joint_rows(const JointSignals& signals, const Scene& scene,
                                       const DataStore& data);

/// What else limits the mechanism: values, limits, and how far it is to the nearer one.
QStringList range_header();
std::vector<CellTable::Row> range_rows(const Scene& scene, const MechanismPose& pose);

/// Sites and fixtures: where they are, and the forces there.
QStringList site_header();
std::vector<CellTable::Row> site_rows(const Scene& scene, const MechanismPose& pose,
                                      const DataStore& data);

}  // namespace trocar::gui
