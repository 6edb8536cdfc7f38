// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "framework/run.hpp"

namespace trocar {

/// What a run was asked to do, as a JSON object for its log: rate [Hz], duration [s] or null, seed,
/// `set` and `edits` of the run, and `overrides`, which come from the command line and win.
std::string run_settings_json(const RunOptions& options, const Graph::Overrides& overrides);

}  // namespace trocar
