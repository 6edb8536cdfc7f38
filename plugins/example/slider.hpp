// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/device.hpp"

namespace example {

using namespace trocar;

/// One axis that moves as a damped mass: the smallest device.
class Slider final : public Device {
 public:
  Slider() {
    declare_device(position_port, hold, effort, effort_sent, scale);
    limits_.axes = 1;
    limits_.effort[0] = 10.0;
    limits_.rise[0] = 1000.0;
    limits_.speed[0] = 1.0;
    limits_.lowest[0] = -0.05;
    limits_.highest[0] = 0.05;
    limits_.margin[0] = 0.005;
    limits_.jump[0] = 0.002;
    limits_.damping[0] = 5.0;
    limits_.damping_cap[0] = 2.0;
    limits_.hold_tolerance[0] = 1.0;
    limits_.handle_speed = 1.0;
  }
  const DeviceLimits& limits() const override { return limits_; }
  bool starts_engaged() const override { return true; }
  void step(const Tick& tick) RT_SAFE override {
    speed_ += (applied_ - 2.0 * speed_) / mass * tick.dt;
    (*position_port)[0] += speed_ * tick.dt;
  }

  Input<Joints> hold{this, "hold", command("holds a weight")};
  Input<Joints> effort{this, "effort", command("to be rendered")};
  Output<Joints> position_port{this, "position", {.unit = "m", .doc = "of the slider"}};
  Output<Joints> effort_sent{this, "effort_sent", {.unit = "N", .doc = "what the gate let pass"}};
  Output<double> scale{this, "scale", {.doc = "share of `effort` that the gate let pass"}};

 private:
  static constexpr double mass = 0.5;  // [kg]
  static PortOptions command(const char* doc) {
    return {.unit = "N", .doc = doc, .optional = true, .feedthrough = false};
  }
  DeviceStatus status() const RT_SAFE override { return {}; }
  void tool_loads(const Joints& rendered, ToolLoads& loads) const RT_SAFE override {
    loads.add({"handle force", {rendered[0], 0.0, 0.0}, 8.0, 16.0, 1.0});
  }
  double handle_speed(const Joints& velocity) const RT_SAFE override {
    return velocity[0] < 0.0 ? -velocity[0] : velocity[0];
  }
  Joints weight() const RT_SAFE override { return {}; }  // it lies flat
  void write(const Tick&, const GatedEffort& gated) RT_SAFE override {
    applied_ = gated.effort()[0];
  }

  DeviceLimits limits_;
  double speed_ = 0.0;
  double applied_ = 0.0;
};

}  // namespace example
