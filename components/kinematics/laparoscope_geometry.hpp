// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/tool_roll.hpp"

namespace trocar {

/// Lengths of the mechanism, all [m]. Frame N: n3 is the insertion axis.
struct LaparoscopeGeometry {
  double tool_length = 0.150;      // l, ball joint A to tip E
  double ring_plane = 0.020;       // zt, height of the ring plane along n3; any sign
  double ring_radius = 0.090;      // r, pin circle; > LaparoscopeLimits::centre_offset
  double base_radius = 0.140;      // Rb, rails; > platform_radius
  double platform_radius = 0.040;  // Rp, >= 0
  double link_length = 0.210;      // L, > base_radius - platform_radius
  RollModel roll = RollModel::gimbal_outer_y;
};

/// Masses and inertias of the moving parts.
struct LaparoscopeMasses {
  double slider = 0.320;                         // m_sl [kg], each
  double link_pair = 0.024;                      // m_lk [kg], both rods of one arm
  double platform = 0.060;                       // m_pl [kg]
  double tool = 0.120;                           // m_tool [kg]
  double tool_centre = 0.105;                    // s_tool [m], centre of mass from A along the tool
  double tool_transverse = 3e-4;                 // I_tt [kg m^2], about the centre of mass
  double tool_axial = 4e-6;                      // I_ta [kg m^2]
  double end_effector = 0.110;                   // m_ee [kg], spokes, gimbal and sleeve, at B
  double end_effector_spin = 1.2e-4;             // I_ee [kg m^2], about n3
  double pin = 0.015;                            // m_pin [kg], each
  double ring = 1.8e-3 + 15.0 * 15.0 * 1.42e-5;  // I_ring + n_cap^2 J_mot [kg m^2], each
};

/// Ranges inside which the device works.
struct LaparoscopeLimits {
  double slider_low = -0.310;               // [m]
  double slider_high = -0.190;              // [m]
  double ring_travel = 4.1887902047863910;  // 240 deg [rad], |phi_i - i 120 deg|
  double centre_offset = 0.060;             // [m], |c|
  double tilt = 0.78539816339744831;        // 45 deg [rad], cone of gimbal and ball joint
  double engagement_low = 0.020;            // [m], M
  double engagement_high = 0.145;           // [m], M
  double link_angle = 1.0471975511965977;   // 60 deg [rad], between a link and its rail
};

/// @throw std::invalid_argument naming the value, what is allowed and the cure.
void validate(const LaparoscopeGeometry& geometry);
void validate(const LaparoscopeMasses& masses);
void validate(const LaparoscopeLimits& limits, const LaparoscopeGeometry& geometry);

}  // namespace trocar
