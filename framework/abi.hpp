// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

/// @file
/// Refuses a compilation whose objects would not fit the libraries'. Eigen's alignment follows the
/// compiler's flags: with -mavx, or -march=native on many machines, the same class has another
/// layout than in the library, and a program that mixes the two crashes far from the cause.
///
/// By the preprocessor alone, so that find_package(Trocar) can ask without compiling.

#if __cplusplus < 202002L
#error "Trocar needs C++20 or newer: compile with -std=c++20"
#endif

// 16 bytes is what Eigen takes without flags, on x86-64 and arm64. The cure: leave out -march=,
// -mavx and Eigen's definitions; or add -DEIGEN_MAX_ALIGN_BYTES=16 to -march= or -mavx.
#if EIGEN_MAX_ALIGN_BYTES != 16 || EIGEN_MAX_STATIC_ALIGN_BYTES != 16
#error "Eigen's alignment is not the 16 bytes of Trocar's libraries, for the cure see above"
#endif
