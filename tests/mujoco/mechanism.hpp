// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "components/kinematics/laparoscope_geometry.hpp"

namespace trocar::test {

/// The laparoscope as a tree of bodies for MuJoCo, and the equations that close its loops.
///
/// Drawn body by body as the device is built, and not from the formulas of
/// components/kinematics, of which it takes lengths and masses only:
///
///   slider i (slides along n3), on it two rods on universal joints;
///   platform, free, with a seat for each of the six rods;
///   ring i (turns about n3) with the hole for its pin;
///   star (slides along n1, n2, turns about n3), on it three pins that slide along its spokes,
///   and the gimbal's two hinges; in the gimbal the tool, which slides along its own axis.
///
/// Closed by 27 equations: each rod's end is at its seat (18), each pin at its hole in n1 and n2
/// (6), the tool's end at the platform's ball joint (3). The zero-torsion joint is a double
/// Cardan joint, hinges y, x, y with equal outer angles: one hinge and one equation more.
///
/// How the model's idealisations are met without masses that no part has:
///  - rods are slender: uniform, without inertia about their own axes;
///  - all that is lumped at B is shared out between the star and the gimbal's parts, which turn
///    about B; only the star has inertia;
///  - `LaparoscopeMasses::ring` includes the pin, so the ring's body has what is left of it;
///  - a slider and the platform do not turn, a ring's axis stays where it is: the inertia or mass
///    that MuJoCo wants of them stands in no equation.
/// MuJoCo refuses an inertia of nothing. Where there is none it gets 1e-14 kg m^2, 2.5e-9 of the
/// tool's smallest: what the dynamics differ by (4e-10 at most) is proportional to it.
struct Mechanism {
  /// Two sites that are at one place.
  struct Closure {
    std::string one, other;
    int axes = 3;  // the first ones of n1, n2, n3
  };

  std::string mjcf;
  std::vector<Closure> sites;
  bool outer_hinges_equal = false;  // of the double Cardan joint
};

/// @param m all masses above 0; ring > pin r^2
Mechanism mechanism(const LaparoscopeGeometry& g, const LaparoscopeMasses& m);

}  // namespace trocar::test
