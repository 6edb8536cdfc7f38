// SPDX-License-Identifier: Apache-2.0
#include "framework/plugin/plugin.hpp"
#include "groove.hpp"
#include "slider.hpp"

namespace {

void add_all(trocar::Registry& registry) {
  registry.add<example::Groove>("Groove", "fixtures", "A groove that keeps a point on a line");
  registry.add<example::Slider>("Slider", "devices", "One axis that moves as a damped mass");
}

}  // namespace

const trocar::Plugin* trocar_plugin() {
  static constexpr trocar::Plugin plugin{
      .name = "example",
      .version = "1.0.0",
      .licence = "Apache-2.0",
      .doc = "A fixture and a simulated device, to be copied",
      .register_with = add_all,
  };
  return &plugin;
}
