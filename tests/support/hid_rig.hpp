// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "components/devices/hid_laparoscope.hpp"
#include "tests/support/emulated_bench.hpp"
#include "tests/support/laparoscope_rig.hpp"

namespace trocar::test {

/// The driver as it is, on a bench: the loop's thread reads and writes, in the bench's time.
class BenchLaparoscope final : public HidLaparoscope {
 public:
  explicit BenchLaparoscope(EmulatedBench& bench) : bench_(bench) {}
  bool needs_real_time() const override { return false; }
  void start() override {
    HidLaparoscope::start();
    start_ns_ = bench_.now();
  }
  void step(const Tick& tick) RT_SAFE override {
    bench_.advance_to(start_ns_ + tick.time_ns);
    HidLaparoscope::step(tick);
  }

 protected:
  std::unique_ptr<hid::DeviceLine> line(const hid::DeviceLineSettings& settings) override {
    hid::DeviceLineSettings threadless = settings;
    threadless.threads = false;
    return std::make_unique<hid::DeviceLine>(std::make_unique<BenchSource>(bench_, *which.serial),
                                             bench_, threadless);
  }

 private:
  EmulatedBench& bench_;
  std::int64_t start_ns_ = 0;
};

/// The same types, the driver on a bench.
inline Registry on_bench(const Registry& all, EmulatedBench& bench) {
  Registry registry;
  for (ComponentType type : all.types()) {
    if (type.name == "HidLaparoscope")
      type.make = [&bench] { return std::make_unique<BenchLaparoscope>(bench); };
    registry.add(std::move(type));
  }
  return registry;
}

inline Registry components_on_bench(EmulatedBench& bench) {
  Registry all;
  register_components(all);
  return on_bench(all, bench);
}

/// Groups Laparoscope { device = "hid" } with a wall each, on emulated devices.
class HidRig {
 public:
  explicit HidRig(const Settings& settings = {}, double rate = 1000.0) : rate_(rate) {
    for (const auto& [key, value] : settings)
      graph.overrides[key] = {.value = literal_from_text(value), .where = {"test", 0}};
  }
  HidRig(const HidRig&) = delete;
  HidRig& operator=(const HidRig&) = delete;

  EmulatedBench::Unit& add_device(
      const hid::EmulatedLaparoscopeSettings& settings = EmulatedBench::settings(1)) {
    return bench.add(settings);
  }
  /// A laparoscope, and a wall of 2.2 N/mm at 105 mm in front of its tip.
  void add_group(const std::string& name = "laparoscope", const std::string& serial = "any") {
    const Where where{"test", 1};
    const NodeId group = *graph.add("Laparoscope", name, where);
    graph.set({group, "device"}, {std::string("hid")}, where);
    graph.set({group, "serial"}, {serial}, where);
    graph.build_group(group);
    const NodeId wall = *graph.add("Wall", name + "_wall", where);
    graph.set({wall, "point"}, literal_from_text("{0, 0, \"105 mm\"}"), where);
    graph.set({wall, "normal"}, literal_from_text("{0, 0, -1}"), where);
    graph.set({wall, "stiffness"}, {std::string("2.2 N/mm")}, where);
    graph.place(wall, graph.node(group).exports.sites.at("tip"), where);
  }
  void start() {
    graph.report_unused_overrides();
    try {
      wired = wire(graph, {.rate = rate_, .seed = 7});
    } catch (const BrokenGraph& broken) {
      qFatal("%s", broken.findings.text().c_str());
    }
    executor = std::make_unique<Executor>(wired->main(),
                                          ExecutorOptions{.timing = false, .commands = &commands});
    executor->start();
  }
  void ask(Command::Kind kind) { commands.try_push({.kind = kind}); }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) executor->tick({next_++, 0, 0}, true);
  }
  void skip(std::int64_t slots) { next_ += slots; }
  /// From power up to rendering by all the rules.
  void engage() {
    ask(Command::Kind::home);
    run(400);
    ask(Command::Kind::engage);
    run(2200);
  }
  HidLaparoscope& device(const std::string& name = "laparoscope") {
    return *static_cast<HidLaparoscope*>(wired->find(name + ".device"));
  }
  const Gate& gate(std::size_t i = 0) const { return executor->gates()[i]; }
  const FaultLatch& faults() const { return executor->faults(); }
  std::string first_fault() const {
    if (faults().size() == 0) return "";
    return std::string(to_string(faults()[0].cause)) + ": " + faults()[0].detail;
  }

  EmulatedBench bench;
  Registry registry = components_on_bench(bench);
  Graph graph{registry};
  CommandQueue commands;
  std::unique_ptr<WiredGraph> wired;
  std::unique_ptr<Executor> executor;

 private:
  double rate_;
  std::int64_t next_ = 0;
};

}  // namespace trocar::test
