// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "framework/executor.hpp"
#include "framework/recording/row_sink.hpp"
#include "tests/support/test_components.hpp"

namespace trocar::test {

/// Does in a step what the test says.
class Puppet final : public Component {
 public:
  using Law = std::function<void(Puppet&, const Tick&)>;
  Input<double> late{this, "late", {.unit = "N", .optional = true, .feedthrough = false}};
  Output<Joints> effort{this, "effort", {.unit = "N, N, N"}};
  Output<double> number{this, "number", {.unit = "N"}};
  Parameter<double> gain{this, "gain", {.unit = "N", .initial = "0 N", .live = true}};
  Parameter<Vector3> shift{this, "shift", {.unit = "N", .initial = "0, 0, 0", .live = true}};
  Parameter<double> fixed{this, "fixed", {.unit = "N", .initial = "0 N"}};
  Law law = [](Puppet&, const Tick&) {};
  std::vector<Tick> steps{};
  std::vector<std::string>* calls = nullptr;

  Puppet() { steps.reserve(100'000); }
  void start() override { note("start"); }
  void step(const Tick& tick) RT_SAFE override {
    if (steps.size() < steps.capacity()) steps.push_back(tick);
    law(*this, tick);
  }
  void stop() override { note("stop"); }
  using Component::fail;

 private:
  void note(const char* what) {
    if (calls != nullptr) calls->push_back(name() + " " + what);
  }
};

/// A fixture at a site whose force, moment and failure are the test's.
class PuppetFixture final : public Component {
 public:
  Input<Vector3> velocity{this, "velocity", {.unit = "m/s", .frame = "device", .optional = true}};
  Output<Vector3> force{this, "force", {.unit = "N", .frame = "device"}};
  Output<Vector3> moment{this, "moment", {.unit = "N m", .frame = "device"}};
  std::function<void(PuppetFixture&, const Tick&)> law = [](PuppetFixture&, const Tick&) {};
  int steps = 0;

  PuppetFixture() { place({.velocity = &velocity, .force = &force, .moment = &moment}); }
  void step(const Tick& tick) RT_SAFE override {
    ++steps;
    law(*this, tick);
  }
  using Component::fail;
};

/// How the tool moves.
class PuppetMotion final : public Component {
 public:
  Output<Vector3> velocity{this, "velocity", {.unit = "m/s", .frame = "device"}};
  void step(const Tick&) RT_SAFE override {}
};

/// Force and moment at the tool → effort, one to one.
class PuppetStatics final : public Component {
 public:
  Inputs<Vector3> forces{this, "forces", {.unit = "N"}};
  Inputs<Vector3> moments{this, "moments", {.unit = "N m"}};
  Output<Joints> effort{this, "effort", {.unit = "N, N, N"}};
  void step(const Tick&) RT_SAFE override { effort->head<3>() = sum(forces) + sum(moments); }
};

/// A graph that is run tick by tick, with everything that it hands over.
class ExecutorRig {
 public:
  ExecutorRig() {
    types.add<Puppet>("Puppet", "test", "does as it is told");
    types.add<PuppetFixture>("PuppetFixture", "test", "a fixture that does as it is told");
    types.add<PuppetMotion>("PuppetMotion", "test", "how the tool moves");
    types.add<PuppetStatics>("PuppetStatics", "test", "forces to effort");
  }
  ExecutorRig(const ExecutorRig&) = delete;
  ExecutorRig& operator=(const ExecutorRig&) = delete;

  NodeId add(std::string_view type, std::string_view name) {
    return graph.add(type, name, {"test", 1}).value();
  }
  void connect(NodeId from, std::string_view output, NodeId to, std::string_view input) {
    graph.connect({from, std::string(output)}, {to, std::string(input)}, {"test", 1});
  }
  /// An arm whose effort and hold puppets give.
  void add_arm() {
    const NodeId arm_node = add("TestDevice", "arm");
    connect(add("Puppet", "rendering"), "effort", arm_node, "effort");
    connect(add("Puppet", "gravity"), "effort", arm_node, "hold");
  }
  void wire(double rate = 1000.0) {
    wired = trocar::wire(graph, {.rate = rate});
    layout = std::make_unique<RowLayout>(wired->main());
  }
  void start(ExecutorOptions options = {}) {
    options.records = &ring;
    options.layout = layout.get();
    options.commands = &commands;
    executor = std::make_unique<Executor>(wired->main(), std::move(options));
    executor->start();
    drain();
  }
  void run(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) {
      executor->tick({next++, 0, 0}, true);
      drain();
    }
  }
  void skip(std::int64_t slots) {
    executor->tick({next + slots, 0, slots}, true);
    next += slots + 1;
    drain();
  }
  template <typename T = Puppet>
  T& get(std::string_view name) {
    return *static_cast<T*>(wired->find(name));
  }
  TestDevice& arm() { return get<TestDevice>("arm"); }
  Command edit(std::string_view component, std::string_view parameter, double target,
               std::int64_t at = 0) {
    Component* owner = wired->find(component);
    return {.kind = Command::Kind::set_parameter,
            .not_before = at,
            .parameter = owner->find_parameter(parameter),
            .owner = owner->name().c_str(),
            .target = {target}};
  }
  /// "3 fault arm: not finite", one for each event.
  std::vector<std::string> told() const {
    std::vector<std::string> all;
    for (const Event& event : events) {
      const bool refused =
          event.kind == Event::Kind::edit_refused || event.kind == Event::Kind::acknowledge_refused;
      const std::string about = refused ? event.detail : event.what;
      all.push_back(std::to_string(event.tick) + " " + to_string(event.kind) +
                    (*event.source != 0 ? std::string(" ") + event.source : std::string()) +
                    (about.empty() ? "" : ": " + about));
    }
    return all;
  }
  void drain() {
    while (const auto record = cursor.next()) {
      if (record->tag == static_cast<std::uint32_t>(RecordKind::row)) {
        rows.emplace_back(record->bytes.begin(), record->bytes.end());
      } else {
        events.emplace_back();
        std::memcpy(&events.back(), record->bytes.data(), sizeof(Event));
      }
    }
  }
  double in_row(std::size_t row, std::string_view signal) const {
    for (const RowSignal& one : layout->signals())
      if (one.name == signal) return number_at(rows.at(row), one.row_offset);
    return std::numeric_limits<double>::quiet_NaN();
  }

  Registry types = registry();
  Graph graph{types};
  std::unique_ptr<WiredGraph> wired;
  std::unique_ptr<RowLayout> layout;
  BroadcastRing ring{std::size_t{1} << 20, std::size_t{1} << 16};
  BroadcastRing::Cursor cursor{ring, BroadcastRing::Cursor::Start::now,
                               BroadcastRing::Cursor::Loss::never};
  CommandQueue commands;
  std::unique_ptr<Executor> executor;
  std::vector<Event> events;
  std::vector<std::vector<std::byte>> rows;
  std::int64_t next = 0;
};

}  // namespace trocar::test
