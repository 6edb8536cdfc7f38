// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/run.hpp"

namespace trocar::lua {

/// A text like "1.5 s" in SI; 0 needs no unit.
/// @param unit that its dimension must be
/// @throw std::invalid_argument
double quantity(const Literal& literal, const char* unit, const std::string& what);

/// Where trocar.run is not told otherwise.
RunOptions default_run_options();

/// What the table of trocar.run may have.
std::vector<std::string> run_option_names();

/// The table that trocar.run takes.
/// @param options what holds where the table says nothing
/// @throw std::invalid_argument with what is wrong and what is possible
RunOptions read_run_options(const Literal& literal, const Where& at, RunOptions options);

}  // namespace trocar::lua
