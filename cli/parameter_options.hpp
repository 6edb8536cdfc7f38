// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <string_view>

#include "framework/parameter_set.hpp"

namespace trocar::cli {

/// "tool_length" is given as "--tool-length".
std::string option_name(std::string_view parameter);

/// An option for each parameter of `set`, which must outlive the command. Values are written as in
/// a script: --tool-length "160 mm". What the parameter refuses is an error of usage, with its
/// range.
/// @param group under which the help lists them
void add_parameter_options(CLI::App& command, ParameterSet& set, const std::string& group);

}  // namespace trocar::cli
