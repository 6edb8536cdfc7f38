// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/kinematics/matrices.hpp"
#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// Velocities after one step with dry friction in every axis, sticking exactly:
///
///   A v + p = b,   |p_i| <= limit_i,   p_i = limit_i sign(v_i) where v_i != 0
///
/// which is the one minimum of  1/2 v^T A v - b^T v + sum limit_i |v_i|.
/// Projected Gauss-Seidel finds which axes stick and which way the others slide; between
/// sweeps a Cholesky solution on the sliding axes jumps to the minimum of that case. Every
/// move lowers the sum, the end is exact, and a stuck axis is exactly 0.
///
/// @param A    [kg, kg m, kg m^2] symmetric, positive definite
/// @param b    [N s, N m s] impulse, @param limit of the friction's impulse, >= 0
/// @param v    in: a guess, best the velocity before the step; out: the solution
/// @return sweeps that were needed, 0 when the guess knew; `friction_sweeps` when the
/// last sweep was taken as it is
int velocity_with_friction(const Matrix6d& A, const Vector6d& b, const Vector6d& limit,
                           Vector6d& v) RT_SAFE;

inline constexpr int friction_sweeps = 40;

}  // namespace trocar
