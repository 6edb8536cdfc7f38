// SPDX-License-Identifier: Apache-2.0
// Each BYPASS is one way round the gate; none may compile.
#include <bit>

#include "framework/gate.hpp"

using namespace trocar;

struct Intruder : Component {
  void step(const Tick&) RT_SAFE override {}
#if BYPASS == 1
  void go(Device& device, const Tick& tick, const GatedEffort& old) {
    device.write(tick, old);
  }
#elif BYPASS == 2
  void go() {
    GatedEffort mine(Joints{}, 0, 0);
  }
#elif BYPASS == 3
  void go(const GatedEffort& old) {
    GatedEffort kept(old);
  }
#elif BYPASS == 4
  void go(GatedEffort& old, const GatedEffort& other) {
    old = other;
  }
#elif BYPASS == 5
  struct Forged {
    double numbers[sizeof(GatedEffort) / sizeof(double)];
  };
  void go() {
    [[maybe_unused]] const auto& mine = std::bit_cast<GatedEffort>(Forged{});
  }
#elif BYPASS == 6
  bool go(const Device& device) {
    return device.status().homed;
  }
#elif BYPASS == 7
  void go(const Device& device, ToolLoads& loads) {
    device.tool_loads({}, loads);
  }
};
struct Heir : GatedEffort {
  Heir() : GatedEffort(Joints{}, 0, 0) {}
#elif BYPASS == 8
};
struct OtherDriver : Device {
  void go(Device& device, const Tick& tick, const GatedEffort& old) { device.write(tick, old); }
#endif
};
