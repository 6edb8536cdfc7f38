// SPDX-License-Identifier: Apache-2.0
#include "cli/available.hpp"

#include <fmt/format.h>

#include "cli/output.hpp"
#include "components/register.hpp"

namespace trocar::cli {

Available available() {
  Available all;
  register_components(all.registry);
  all.plugins = load_plugins(all.registry, plugin_folders());
  return all;
}

void warn_of_refused(const Plugins& plugins) {
  for (const RefusedPlugin& plugin : plugins.refused)
    for (const std::string& reason : plugin.reasons)
      complain(fmt::format("warning: plugin {}: {}", plugin.file.string(), reason));
}

Registry available_components() {
  Available all = available();
  warn_of_refused(all.plugins);
  return std::move(all.registry);
}

}  // namespace trocar::cli
