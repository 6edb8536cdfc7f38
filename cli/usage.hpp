// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>

namespace trocar::cli {

/// What holds for every command: --version, --help and how help looks.
void set_up(CLI::App& app);

/// Prints what the parser has to say: help and version to standard output, a mistake to standard
/// error with the nearest right name. @return the exit status
int report(const CLI::App& app, const CLI::ParseError& error);

}  // namespace trocar::cli
