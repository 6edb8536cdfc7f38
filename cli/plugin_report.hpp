// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "framework/plugin/plugin_loader.hpp"

namespace trocar::cli {

/// The plugins with what they bring, those that were refused with the reasons, and where all of
/// them were looked for.
std::string plugins_text(const Plugins& plugins, const std::vector<PluginFolder>& searched);
nlohmann::ordered_json plugins_json(const Plugins& plugins,
                                    const std::vector<PluginFolder>& searched);
std::vector<std::string> plugin_names(const Plugins& plugins);

}  // namespace trocar::cli
