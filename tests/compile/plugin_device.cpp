// SPDX-License-Identifier: Apache-2.0
// A device of a plugin. Each BYPASS is one way of its own round the gate; none may compile. With 0
// it is a device as it should be, and must.
#include <optional>

#include "framework/gate.hpp"
#include "framework/plugin/plugin.hpp"

using namespace trocar;

namespace {

#if BYPASS == 1
struct MyGate : Gate {  // a friend's heirs are no friends
  static GatedEffort make() { return GatedEffort(Joints{}, 0, 0); }
};
#endif

struct Driver final : Device {
  Driver() { declare_device(position_port, hold, effort, effort_sent, scale); }
  const DeviceLimits& limits() const override { return limits_; }

#if BYPASS == 2
  void step(const Tick& tick) RT_SAFE override {
    write(tick, GatedEffort(Joints{}, 0, 0));
  }
#elif BYPASS == 3
  void step(const Tick& tick) RT_SAFE override {
    write(tick, {});
  }
#elif BYPASS == 4
  void step(const Tick& tick) RT_SAFE override {
    write(tick, *effort);
  }
#else
  void step(const Tick&) RT_SAFE override {}
#endif

  Input<Joints> hold{this, "hold", {.unit = "N", .optional = true, .feedthrough = false}};
  Input<Joints> effort{this, "effort", {.unit = "N", .optional = true, .feedthrough = false}};
  Output<Joints> position_port{this, "position", {.unit = "m"}};
  Output<Joints> effort_sent{this, "effort_sent", {.unit = "N"}};
  Output<double> scale{this, "scale", {}};

 private:
  DeviceStatus status() const RT_SAFE override {
    return {};
  }
  void tool_loads(const Joints&, ToolLoads&) const RT_SAFE override {}
  double handle_speed(const Joints&) const RT_SAFE override {
    return 0.0;
  }
  Joints weight() const RT_SAFE override {
    return {};
  }
#if BYPASS == 5
  void write(const Tick&, const GatedEffort& gated) RT_SAFE override {
    kept_.emplace(gated);
  }
  std::optional<GatedEffort> kept_;
#elif BYPASS == 6
  void write(const Tick&, const GatedEffort& gated) RT_SAFE override {
    gated.effort_[0] = 1e3;
  }
#elif BYPASS == 7
  void write(const Tick&, const Joints&) RT_SAFE override {}  // effort of another type
#else
  void write(const Tick&, const GatedEffort& gated) RT_SAFE override {
    motor_ = gated.effort()[0];
  }
#endif

  DeviceLimits limits_;
  double motor_ = 0.0;
};

void add_all(Registry& registry) {
#if BYPASS == 1
  MyGate::make();
#endif
  registry.add<Driver>("Driver", "devices", "One axis");
}

}  // namespace

const Plugin* trocar_plugin() {
  static constexpr Plugin plugin{.name = "driver",
                                 .version = "1",
                                 .licence = "MIT",
                                 .doc = "One axis",
                                 .register_with = add_all};
  return &plugin;
}
