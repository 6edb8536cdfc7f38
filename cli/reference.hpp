// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "framework/registry.hpp"

namespace trocar::cli {

/// All component types with their ports and parameters, in Markdown: docs/components.md.
std::string reference_markdown(const Registry& registry);

}  // namespace trocar::cli
