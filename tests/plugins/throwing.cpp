// SPDX-License-Identifier: Apache-2.0
// A plugin that gives up after its first component.
#include <stdexcept>

#include "framework/plugin/plugin.hpp"

namespace {

using namespace trocar;

struct Half final : Component {
  void step(const Tick&) RT_SAFE override {}
};

void add_all(Registry& registry) {
  registry.add<Half>("Half", "sources", "Of what was to come");
  throw std::runtime_error("the engine has no licence");
}

}  // namespace

const trocar::Plugin* trocar_plugin() {
  static constexpr trocar::Plugin plugin{.name = "throwing",
                                         .version = "1",
                                         .licence = "MIT",
                                         .doc = "Gives up",
                                         .register_with = add_all};
  return &plugin;
}
