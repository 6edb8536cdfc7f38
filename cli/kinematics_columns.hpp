// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "components/kinematics/laparoscope_geometry.hpp"

/// @file
/// The columns by which a row of a table brings a geometry and masses of its own.

namespace trocar::cli {

template <typename Owner>
struct OwnColumn {
  const char* column;
  double Owner::*member;
  const char* name;  // as errors call it
};

using GeometryColumn = OwnColumn<LaparoscopeGeometry>;
using MassColumn = OwnColumn<LaparoscopeMasses>;

inline constexpr std::array geometry_columns = {
    GeometryColumn{"l", &LaparoscopeGeometry::tool_length, "tool_length"},
    GeometryColumn{"zt", &LaparoscopeGeometry::ring_plane, "ring_plane"},
    GeometryColumn{"r", &LaparoscopeGeometry::ring_radius, "ring_radius"},
    GeometryColumn{"Rb", &LaparoscopeGeometry::base_radius, "base_radius"},
    GeometryColumn{"Rp", &LaparoscopeGeometry::platform_radius, "platform_radius"},
    GeometryColumn{"L", &LaparoscopeGeometry::link_length, "link_length"}};

/// What has weight.
inline constexpr std::array mass_columns = {
    MassColumn{"m_sl", &LaparoscopeMasses::slider, "slider"},
    MassColumn{"m_lk", &LaparoscopeMasses::link_pair, "link_pair"},
    MassColumn{"m_pl", &LaparoscopeMasses::platform, "platform"},
    MassColumn{"m_tool", &LaparoscopeMasses::tool, "tool"},
    MassColumn{"s_tool", &LaparoscopeMasses::tool_centre, "tool_centre"},
    MassColumn{"m_ee", &LaparoscopeMasses::end_effector, "end_effector"},
    MassColumn{"m_pin", &LaparoscopeMasses::pin, "pin"}};

/// What only resists acceleration.
inline constexpr std::array inertia_columns = {
    MassColumn{"I_tt", &LaparoscopeMasses::tool_transverse, "tool_transverse"},
    MassColumn{"I_ta", &LaparoscopeMasses::tool_axial, "tool_axial"},
    MassColumn{"I_ee", &LaparoscopeMasses::end_effector_spin, "end_effector_spin"},
    MassColumn{"I_ring_eff", &LaparoscopeMasses::ring, "ring"}};

inline constexpr std::array gravity_columns = {"gx", "gy", "gz"};
inline constexpr std::array effort_columns = {"u1", "u2", "u3", "u4", "u5", "u6"};
inline constexpr std::array wrench_columns = {"F1", "F2", "F3", "F4", "F5", "F6"};

}  // namespace trocar::cli
