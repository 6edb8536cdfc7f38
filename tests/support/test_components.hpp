// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/graph.hpp"
#include "tests/support/gate_rig.hpp"

/// @file
/// Small components that wiring tests need, under the names that registry() gives them.

namespace trocar::test {

struct Number final : Component {
  Parameter<double> amplitude{this, "amplitude", {.unit = "m", .initial = "1 mm", .max = "1 m"}};
  Output<double> value{this, "value", {.unit = "m"}};
  void step(const Tick& tick) RT_SAFE override { *value = *amplitude * tick.time; }
};

struct Follower final : Component {
  Input<double> input{this, "input", {.unit = "m", .doc = "what it follows"}};
  Input<double> late{this, "late", {.unit = "m", .optional = true, .feedthrough = false}};
  Output<double> value{this, "value", {.unit = "m"}};
  void step(const Tick&) RT_SAFE override { *value = *input; }
};

/// Required parameter, a frame, a force.
struct Spring final : Component {
  Parameter<double> stiffness{
      this, "stiffness", {.unit = "N/m", .max = "50 N/mm", .doc = "how hard it pushes"}};
  Input<Vector3> position{this, "position", {.unit = "m", .frame = "device", .doc = "where"}};
  Output<Vector3> force{this, "force", {.unit = "N", .frame = "device"}};
  Spring() { place({.position = &position, .force = &force}); }
  void configure(const Setup&) override {
    if (*stiffness > 20e3) throw std::invalid_argument("too stiff for the loop");
  }
  void step(const Tick&) RT_SAFE override { force->eigen() = -*stiffness * position->eigen(); }
};

struct Points final : Component {
  Output<PointMotion> tip{this, "tip", {.frame = "device"}};
  Output<PointMotion> camera{this, "camera", {.frame = "camera"}};
  void step(const Tick&) RT_SAFE override {}
};

/// Vector force at the tool → effort of the axes.
struct Statics final : Component {
  Inputs<Vector3> forces{this, "forces", {.unit = "N"}};
  Input<double> offset{this, "offset", {.unit = "m", .optional = true}};
  Output<Joints> effort{this, "effort", {.unit = "N, N, N"}};
  void step(const Tick&) RT_SAFE override {}
};

struct GenericSum final : Component {
  GenericInput inputs{this, "inputs", {}, true};
  GenericOutput value{this, "value", {}};
  void step(const Tick&) RT_SAFE override {
    for (std::size_t i = 0; i < value.values().size(); ++i) {
      value.values()[i] = 0.0;
      for (std::size_t s = 0; s < inputs.count(); ++s) value.values()[i] += inputs.values(s)[i];
    }
  }
};

/// Generic, and a number in its parameter's unit where nothing else is known.
struct GenericConstant final : Component {
  Parameter<Quantity> quantity{this, "quantity", {.initial = "0"}};
  GenericOutput value{this, "value", {}};
  std::optional<Signature> natural_signature() const override {
    return Signature{&type_info<double>(), 0, {quantity->unit}, ""};
  }
  void step(const Tick&) RT_SAFE override {
    for (double& number : value.values()) number = quantity->value;
  }
};

struct Pair final : Group {
  Parameter<double> amplitude{this, "amplitude", {.unit = "m", .initial = "5 mm"}};
  void build(GroupScope& scope) override {
    const NodeId source = scope.add("Number", "source");
    const NodeId end = scope.add("Follower", "end");
    scope.connect({source, "value"}, {end, "input"});
    scope.forward("amplitude", source, "amplitude");
    scope.exports().outputs["value"] = {end, "value"};
    scope.exports().inputs["late"] = {end, "late"};
  }
};

inline Registry registry() {
  Registry all;
  all.add<Number>("Number", "test", "a number");
  all.add<Follower>("Follower", "test", "repeats its input");
  all.add<Spring>("Spring", "test", "a spring");
  all.add<Points>("Points", "test", "points in two frames");
  all.add<Statics>("Statics", "test", "forces to effort");
  all.add<GenericSum>("GenericSum", "test", "a sum");
  all.add<GenericConstant>("GenericConstant", "test", "a constant");
  all.add<TestDevice>("TestDevice", "test", "a device");
  all.add<Pair>("Pair", "test", "a group");
  return all;
}

}  // namespace trocar::test
