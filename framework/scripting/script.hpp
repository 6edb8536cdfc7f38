// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "framework/session.hpp"

namespace trocar {

/// Runs a graph script: it describes a graph in the session, and may run it. A script that ran
/// nothing itself has its graph run once at the end, unless the session only checks.
/// @param arguments entries of `trocar.args`; one that the script never asked for is a finding
/// @throw BrokenGraph with every finding of script and graph, or that the file cannot be read
void run_script(Session& session, const std::string& path, Graph::Overrides arguments = {});

}  // namespace trocar
