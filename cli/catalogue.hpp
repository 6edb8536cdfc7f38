// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "framework/registry.hpp"

namespace trocar::cli {

/// The component types by category, each with one line of documentation.
std::string catalogue_text(const Registry& registry);
nlohmann::ordered_json catalogue_json(const Registry& registry);

}  // namespace trocar::cli
