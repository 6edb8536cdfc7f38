// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "framework/registry.hpp"

namespace trocar::cli {

/// In the order in which they were registered first.
std::vector<std::string> categories_of(const Registry& registry);

/// The component types by category, each with one line of documentation.
std::string catalogue_text(const Registry& registry);
nlohmann::ordered_json catalogue_json(const Registry& registry);

}  // namespace trocar::cli
