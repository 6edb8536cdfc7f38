// SPDX-License-Identifier: Apache-2.0
// A plugin whose names are those of good.so, but for one.
#include "framework/plugin/plugin.hpp"

namespace {

using namespace trocar;

struct Idle final : Component {
  void step(const Tick&) RT_SAFE override {}
};

void add_all(Registry& registry) {
  registry.add<Idle>("Twin", "sources", "Free");
  registry.add<Idle>("Nudge", "sources", "Taken");
  registry.add(
      ServiceType{.name = "beacon", .doc = "Taken", .start = [](const auto&) { return nullptr; }});
}

}  // namespace

const trocar::Plugin* trocar_plugin() {
  static constexpr trocar::Plugin plugin{.name = "twin",
                                         .version = "1",
                                         .licence = "MIT",
                                         .doc = "The same again",
                                         .register_with = add_all};
  return &plugin;
}
