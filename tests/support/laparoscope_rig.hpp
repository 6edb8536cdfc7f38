// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>
#include <limits>
#include <memory>
#include <string>

#include "components/devices/simulated_laparoscope.hpp"
#include "components/kinematics/laparoscope_kinematics.hpp"
#include "components/register.hpp"
#include "framework/executor.hpp"

namespace trocar::test {

/// Pushes back along -z beyond a height, and gives NaN from a tick on.
class TestFixture final : public Component {
 public:
  TestFixture() { place({.position = &position, .velocity = &velocity, .force = &force}); }
  void step(const Tick& tick) RT_SAFE override {
    const double inside = std::max(0.0, position->z - *height);
    *force = {*constant, 0.0, -*stiffness * inside - (inside > 0 ? *damping * velocity->z : 0.0)};
    if (tick.index >= *broken_from) force->y = std::numeric_limits<double>::quiet_NaN();
  }
  Input<Vector3> position{this, "position", {.unit = "m", .frame = "device"}};
  Input<Vector3> velocity{this, "velocity", {.unit = "m/s", .frame = "device"}};
  Output<Vector3> force{this, "force", {.unit = "N", .frame = "device"}};
  Parameter<double> height{this, "height", {.unit = "m", .initial = "105 mm"}};
  Parameter<double> stiffness{this, "stiffness", {.unit = "N/m", .initial = "2.2 N/mm"}};
  Parameter<double> damping{this, "damping", {.unit = "N s/m", .initial = "0 N s/m"}};
  Parameter<double> constant{this, "constant", {.unit = "N", .initial = "0 N"}};
  Parameter<std::int64_t> broken_from{this, "broken_from", {.initial = "1e15"}};
};

/// A weight that hangs at a site, or whatever else pulls there from outside.
class TestLoad final : public Component {
 public:
  TestLoad() { place({.force = &force, .acts = Placement::Acts::on_tool}); }
  void step(const Tick&) RT_SAFE override { *force = *pull; }
  Output<Vector3> force{this, "force", {.unit = "N", .frame = "device"}};
  Parameter<Vector3> pull{this, "pull", {.unit = "N", .initial = "0, 0, 0"}};
};

using Settings = std::vector<std::pair<std::string, std::string>>;

/// The group Laparoscope, wired and run tick by tick.
class LaparoscopeRig {
 public:
  explicit LaparoscopeRig(const Settings& settings = {}, double rate = 1000.0) : rate_(rate) {
    register_components(registry);
    registry.add<TestFixture>("TestFixture", "test", "a force at a site");
    registry.add<TestLoad>("TestLoad", "test", "a load at a site");
    for (const auto& [key, value] : settings)
      graph.overrides[key] = {.value = literal_from_text(value), .where = {"test", 0}};
    group = *graph.add("Laparoscope", "", {"test", 1});
    graph.build_group(group);
  }
  LaparoscopeRig(const LaparoscopeRig&) = delete;
  LaparoscopeRig& operator=(const LaparoscopeRig&) = delete;

  void place(const char* type, const char* name, const char* site) {
    const NodeId node = *graph.add(type, name, {"test", 2});
    graph.place(node, graph.node(group).exports.sites.at(site), {"test", 2});
  }

  /// Wires and starts.
  void start(std::vector<Command> schedule = {}) {
    graph.report_unused_overrides();
    try {
      wired = wire(graph, {.rate = rate_, .seed = 7});
    } catch (const BrokenGraph& broken) {
      qFatal("%s", broken.findings.text().c_str());
    }
    device = static_cast<SimulatedLaparoscope*>(wired->find("laparoscope.device"));
    tool = static_cast<LaparoscopeKinematics*>(wired->find("laparoscope.tool"));
    executor = std::make_unique<Executor>(
        wired->main(), ExecutorOptions{.timing = false, .schedule = std::move(schedule)});
    executor->start();
  }
  void tick() { executor->tick({next_++, 0, 0}, true); }
  void skip(std::int64_t count) {
    executor->tick({next_ + count, 0, count}, true);
    next_ += count + 1;
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) tick();
  }
  const Fault* fault(FaultCause cause) const {
    for (std::size_t i = 0; i < executor->faults().size(); ++i)
      if (executor->faults()[i].cause == cause) return &executor->faults()[i];
    return nullptr;
  }
  Gate::State state() const { return executor->gates().front().state(); }
  std::int64_t next() const { return next_; }

  Registry registry;
  Graph graph{registry};
  NodeId group = 0;
  std::unique_ptr<WiredGraph> wired;
  std::unique_ptr<Executor> executor;
  SimulatedLaparoscope* device = nullptr;
  LaparoscopeKinematics* tool = nullptr;

 private:
  double rate_;
  std::int64_t next_ = 0;
};

}  // namespace trocar::test
