// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "framework/session.hpp"

namespace trocar {

/// What a session came to, in words: each run's forces, timing and faults, the log, the results.
std::string report_text(const Session& session);

/// The same for programs. Objects: "runs" (list), "published" (name → list of rows), "log",
/// "troubles". Times in s, values in SI.
std::string report_json(const Session& session);

}  // namespace trocar
