// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>

#include "framework/gate.hpp"

namespace trocar::test {

/// Three linear axes whose motors the test reads. Its handle is loaded by G effort; its status,
/// limits and position are the test's to set.
class TestDevice final : public Device {
 public:
  Output<Joints> reported{this, "position", {.unit = "m, m, m", .doc = "axis positions"}};
  Input<Joints> hold{
      this,
      "hold",
      {.unit = "N, N, N", .doc = "what keeps the tool up", .optional = true, .feedthrough = false}};
  Input<Joints> effort{
      this,
      "effort",
      {.unit = "N, N, N", .doc = "what is rendered", .optional = true, .feedthrough = false}};
  Input<double> load{this, "load", {.unit = "N", .optional = true, .feedthrough = false}};
  Output<Joints> effort_sent{this, "effort_sent", {.unit = "N, N, N"}};
  Output<double> scale{this, "scale", {}};
  Output<double> truth_height{this, "truth.height", {.unit = "m"}};
  Output<double> truth_force{this, "truth.force", {.unit = "N"}};
  Output<Joints> truth_effort{this, "truth.effort", {.unit = "N, N, N"}};
  Parameter<bool> declares_limits{this, "declares_limits", {.initial = "true"}};

  DeviceLimits declared;
  DeviceStatus report;
  bool engaged_at_start = true;
  double cap = 20.0;  // [N] at the handle
  double load_trip = std::numeric_limits<double>::infinity();
  int loads = 1;
  Joints own_weight{};  // [N]
  Joints written{}, written_hold{};
  std::int64_t written_tick = -1, written_deadline = 0;
  DeviceMode written_mode = DeviceMode::off;
  bool acknowledged = false;
  int writes = 0;
  std::atomic<int> stalls{0};  // that the supervisor told of, on its own thread

  TestDevice() { declare_device(reported, hold, effort, effort_sent, scale); }

  const DeviceLimits& limits() const override { return declared; }
  bool starts_engaged() const override { return engaged_at_start; }
  void configure(const Setup&) override {
    if (*declares_limits) declare_limits();
  }
  std::function<void(TestDevice&, const Tick&)> law = [](TestDevice&, const Tick&) {};
  void step(const Tick& tick) RT_SAFE override { law(*this, tick); }
  using Component::fail;

  void declare_limits() {
    declared.axes = 3;
    const auto fill = [](Joints& joints, double value) {
      for (int i = 0; i < 3; ++i) joints[i] = value;
    };
    fill(declared.effort, 12.0);
    fill(declared.rise, 1000.0);
    fill(declared.speed, 1.0);
    fill(declared.lowest, -0.1);
    fill(declared.highest, 0.1);
    fill(declared.margin, 0.005);
    fill(declared.jump, 0.01);
    fill(declared.damping, 5.0);
    fill(declared.damping_cap, 2.0);
    fill(declared.hold_tolerance, 12.0);
    declared.handle_speed = 0.8;
  }

  /// [N] at the handle for effort: coupled, so that direction matters.
  static Eigen::Vector3d handle_force(const Joints& effort) RT_SAFE {
    return {effort[0] + 0.5 * effort[1], 2.0 * effort[1], effort[2] - 0.3 * effort[0]};
  }

 private:
  void loop_stalled() override { ++stalls; }
  DeviceStatus status() const RT_SAFE override { return report; }
  void tool_loads(const Joints& of, ToolLoads& all) const RT_SAFE override {
    for (int i = 0; i < loads; ++i)
      all.add({"handle force", Vector3(handle_force(of)), cap, load_trip, 1.0});
  }
  double handle_speed(const Joints& velocity) const RT_SAFE override {
    return velocity.head<3>().norm();
  }
  Joints weight() const RT_SAFE override { return own_weight; }
  void write(const Tick&, const GatedEffort& gated) RT_SAFE override {
    written = gated.effort();
    written_hold = gated.hold();
    written_tick = gated.tick();
    written_deadline = gated.deadline_ns();
    written_mode = gated.mode();
    acknowledged = gated.acknowledges();
    ++writes;
  }
};

/// A device, what feeds it, and its gate, one tick a call.
class GateRig {
 public:
  class Feed final : public Component {
   public:
    Output<Joints> hold{this, "hold", {.unit = "N, N, N"}};
    Output<Joints> effort{this, "effort", {.unit = "N, N, N"}};
    void step(const Tick&) RT_SAFE override {}
  };

  TestDevice device;
  Feed feed;
  FaultLatch faults;
  Joints& hold = *feed.hold;
  Joints& effort = *feed.effort;
  Joints& position = *device.reported;
  static constexpr double period = 1e-3;  // [s]

  GateRig() {
    device.set_name("arm");
    device.declare_limits();
    device.hold.connect({&feed.hold, 0});
    device.effort.connect({&feed.effort, 0});
  }
  GateRig(const GateRig&) = delete;
  GateRig& operator=(const GateRig&) = delete;

  Gate& gate() {
    if (!gate_) gate_.emplace(device, period, faults);
    return *gate_;
  }
  void pass(int ticks = 1, bool effort_usable = true, bool hold_usable = true) RT_SAFE {
    for (int i = 0; i < ticks; ++i) {
      gate_->pass({.index = tick, .time_ns = tick * 1'000'000}, effort_usable, hold_usable);
      ++tick;
    }
  }
  /// A cold device that is held, calm and engaged by all the rules.
  void engage_from_cold() {
    device.engaged_at_start = false;
    gate();
    pass(1002);
    gate_->request_engage();
    pass(1002);
  }
  double sent(int axis) const { return device.written[axis]; }
  std::int64_t tick = 0;

 private:
  std::optional<Gate> gate_;
};

}  // namespace trocar::test
