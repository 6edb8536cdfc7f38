// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "cli/log_summary.hpp"

namespace trocar::cli {

/// @param pattern the signals whose values are wanted ("" all); none: signals are listed by name
std::string log_text(const LogSummary& log, const std::optional<std::string>& pattern);
nlohmann::ordered_json log_json(const LogSummary& log, const std::optional<std::string>& pattern);

}  // namespace trocar::cli
