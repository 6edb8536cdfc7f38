// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/data/data_store.hpp"
#include "gui/device/laparoscope_setup.hpp"

namespace trocar::gui {

/// What there is to be seen of a graph in space, and which signals tell where it is. All of it in
/// the device's base frame N.
struct Scene {
  struct Fixture {
    enum class Kind { wall, spring, other };
    Kind kind = Kind::other;
    std::string name;                                  // "wall"
    std::string position;                              // signal of the point that it acts on
    std::string force;                                 // [N] on that point
    std::string depth;                                 // [m] inside a wall
    std::string offset;                                // [m] of a wall's surface along its normal
    std::string displacement;                          // [m] of a spring from its centre
    Eigen::Vector3d point = Eigen::Vector3d::Zero();   // of a wall's surface [m]
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // of a wall, unit, out of it
  };
  struct Site {
    std::string name;      // "tip"; where several devices have one, with the device's: "left.tip"
    std::string position;  // signal
    std::vector<std::string> forces;  // signals [N] that act there
  };

  std::optional<LaparoscopeSetup> laparoscope;
  std::string wrench;  // signal: asked for at E, "" where there is none
  std::string scale;   // signal: share of it that the gate lets through
  std::vector<Site> sites;
  std::vector<Fixture> fixtures;

  static Scene of(const nlohmann::json& graph);
};

/// The three numbers of a vector in the newest row that is shown; nothing where one is missing.
std::optional<Eigen::Vector3d> newest_vector(const DataStore& data, const std::string& signal);
/// NaN where there is none.
double newest_number(const DataStore& data, const std::string& signal);

}  // namespace trocar::gui
