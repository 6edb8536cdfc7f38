// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/plugin/plugin_loader.hpp"
#include "framework/registry.hpp"

namespace trocar::cli {

/// What scripts can use: what is built in, and what the plugins of the search path bring.
struct Available {
  Registry registry;
  Plugins plugins;
};
Available available();

/// Complains of each plugin that was refused. That is no reason to end: only a script that needs
/// what is missing is broken.
void warn_of_refused(const Plugins& plugins);

/// What scripts can use, with that complaint.
Registry available_components();

}  // namespace trocar::cli
