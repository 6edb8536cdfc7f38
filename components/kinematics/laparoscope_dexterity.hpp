// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/laparoscope_model.hpp"

namespace trocar {

/// What the actuators can give.
struct LaparoscopeEfforts {
  double slider_peak = 200.0;       // [N]
  double slider_continuous = 60.0;  // [N]
  double ring_peak = 12.0;          // [N m], at the ring
  double ring_continuous = 2.7;     // [N m]

  Vector6d peak() const;
  Vector6d continuous() const;
};

/// @throw std::invalid_argument naming the value, what is allowed and the cure.
void validate(const LaparoscopeEfforts& efforts);

/// How well the device moves and pushes the tool in one configuration.
struct Dexterity {
  double condition;         // largest over smallest singular value of the scaled J
  double manipulability;    // |det| of the scaled J (Yoshikawa 1985)
  double peak_force;        // [N] at E, without a moment, in the worst direction
  double continuous_force;  // [N]
};

/// J is scaled to pure numbers: a turn of the tool counts by what it moves at 0.1 m from its
/// centre, a ring's by what it moves its pin.
///
///   (v; 0.1 m omega) = J_scaled (q_1..3'; r phi_1..3')
///
/// A force f in the direction u takes f |Jv_i·u| of axis i, Jv_i being the column of velocities of
/// E. The worst direction is that of one of the columns: f = min_i spare_i / |Jv_i|.
///
/// @param peak, continuous spare efforts [N, N m], >= 0
Dexterity dexterity(const LaparoscopeRates& rates, double ring_radius, const Vector6d& peak,
                    const Vector6d& continuous);

/// The largest force in one direction [N]. @param direction unit vector in N
double force_along(const LaparoscopeRates& rates, const Eigen::Vector3d& direction,
                   const Vector6d& spare);

}  // namespace trocar
