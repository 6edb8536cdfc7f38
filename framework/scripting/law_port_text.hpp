// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "framework/scripting/law_file.hpp"

namespace trocar::lua {

/// Reads what a law wrote for a port.
/// @throw std::invalid_argument with what is needed, and an example
LawPort read_law_port(const std::string& name, const Literal& written);

}  // namespace trocar::lua
