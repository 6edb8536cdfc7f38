// SPDX-License-Identifier: Apache-2.0
// A sound plugin with a component and a service. It leaves a trace when it is loaded.
#include <cstdlib>

#include "framework/plugin/plugin.hpp"
#include "framework/recording/row_sink.hpp"

namespace {

using namespace trocar;

[[maybe_unused]] const int trace = setenv("TROCAR_TEST_PLUGIN_RAN", "1", 1);

struct Nudge final : Component {
  Output<double> force{this, "force", {.unit = "N", .doc = "always the same"}};
  void step(const Tick&) RT_SAFE override { *force = 1.5; }
};

struct Beacon final : Service, RowSink {
  std::string greeting() const override { return "seen from afar"; }
  RowSink& rows() override { return *this; }
  void row(std::size_t, std::span<const std::byte>) override {}
  bool operate(RunControl&) override { return false; }
};

void add_all(Registry& registry) {
  registry.add<Nudge>("Nudge", "sources", "One and a half newton");
  registry.add(ServiceType{.name = "beacon", .doc = "Shines", .start = [](const auto&) {
                             return std::make_unique<Beacon>();
                           }});
}

}  // namespace

const trocar::Plugin* trocar_plugin() {
  static constexpr trocar::Plugin plugin{.name = "good",
                                         .version = "2.1",
                                         .licence = "MIT",
                                         .doc = "A nudge and a beacon",
                                         .register_with = add_all};
  return &plugin;
}
