// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// @file
/// The version, in the only place that it is written: CMake reads these three lines.

#define TROCAR_VERSION_MAJOR 0
#define TROCAR_VERSION_MINOR 1
#define TROCAR_VERSION_PATCH 0

namespace trocar {

/// "0.1.0": of the library that runs, whose patch may be newer than that of the header.
std::string version();

}  // namespace trocar
