// SPDX-License-Identifier: Apache-2.0
#include "framework/plugin/plugin.hpp"
#include "plugins/foxglove/foxglove_service.hpp"

namespace {

void add_service(trocar::Registry& registry) {
  registry.add(trocar::foxglove::foxglove_service());
}

}  // namespace

const trocar::Plugin* trocar_plugin() {
  static constexpr trocar::Plugin plugin{
      .name = "foxglove",
      .version = TROCAR_PLUGIN_VERSION,
      .licence = "Apache-2.0",
      .doc = "A live stream by the Foxglove WebSocket protocol",
      .register_with = add_service,
  };
  return &plugin;
}
