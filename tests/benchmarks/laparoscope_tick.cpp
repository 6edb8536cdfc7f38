// SPDX-License-Identifier: Apache-2.0
// The laparoscope at a wall, as the first tutorial has it: a tick of the graph beside the same
// calculation as one straight function.
#include <benchmark/benchmark.h>

#include "components/devices/simulated_laparoscope.hpp"
#include "components/kinematics/laparoscope_kinematics.hpp"
#include "components/register.hpp"
#include "tests/benchmarks/bench_graph.hpp"
#include "tests/benchmarks/straight_laparoscope.hpp"

namespace trocar::bench {
namespace {

constexpr int ticks = 3000;  // the hand reaches the wall after 1.28 s, and leans on it

/// Notes the seed that a component of its name gets.
class SeedProbe final : public Component {
 public:
  void configure(const Setup& setup) override { seed = setup.seed; }
  void step(const Tick&) RT_SAFE override {}
  std::uint64_t seed = 0;
};

std::uint64_t seed_of_device() {
  BenchGraph bench;
  bench.types.add<SeedProbe>("SeedProbe", "bench", "notes its seed");
  const NodeId probe = *bench.graph.add("SeedProbe", "device", {"benchmark", 1}, "laparoscope");
  bench.start();
  return static_cast<const SeedProbe&>(*bench.wired->component(probe)).seed;
}

/// scripts/tutorial/01_feel_a_wall.lua
class FeelAWall {
 public:
  FeelAWall() {
    register_components(bench_.types);
    Graph& graph = bench_.graph;
    const NodeId group = bench_.add("Laparoscope");
    graph.set({group, "hand"}, literal_from_text("push"), {});
    graph.build_group(group);
    const NodeId fixture = bench_.add("Wall");
    graph.set({fixture, "point"}, literal_from_text("0, 0, 105 mm"), {});
    graph.set({fixture, "normal"}, literal_from_text("0, 0, -1"), {});
    graph.set({fixture, "stiffness"}, literal_from_text("2.2 N/mm"), {});
    graph.place(fixture, graph.node(group).exports.sites.at("tip"), {});
    bench_.start();
    device = &static_cast<const SimulatedLaparoscope&>(*bench_.wired->find("laparoscope.device"));
    tool = &static_cast<const LaparoscopeKinematics&>(*bench_.wired->find("laparoscope.tool"));
    wall = &static_cast<const Wall&>(*bench_.wired->find("wall"));
  }
  void tick() { bench_.tick(); }
  bool faulty() const { return bench_.executor->faults().latched(); }

  const SimulatedLaparoscope* device = nullptr;
  const LaparoscopeKinematics* tool = nullptr;
  const Wall* wall = nullptr;

 private:
  BenchGraph bench_;
};

StraightSettings settings_as_in(const FeelAWall& graph) {
  const SimulatedLaparoscope& device = *graph.device;
  StraightSettings settings;
  settings.plant = device.plant_settings({.seed = seed_of_device()});
  settings.nominal = device.masses.value();
  settings.wall = {graph.wall->point->eigen(), graph.wall->normal->eigen(), *graph.wall->stiffness};
  return settings;
}

/// "" when graph and straight function gave the same numbers, bit by bit; else what differs.
std::string difference(const FeelAWall& graph, const StraightLaparoscope& straight) {
  const LaparoscopeKinematics& tool = *graph.tool;
  if (graph.faulty() || straight.tripped) return "a fault";
  if (graph.device->device_position->head<6>() != straight.position) return "the position differs";
  if (tool.tip->velocity.eigen() != straight.tip.velocity.eigen()) return "the tip's speed differs";
  if (tool.twist->eigen() != straight.twist.eigen()) return "the twist differs";
  if (tool.angles->eigen() != straight.angles.eigen()) return "the angles differ";
  if (graph.wall->force->eigen() != straight.contact.force) return "the wall's force differs";
  if (graph.device->truth.hand_force->eigen() != straight.hand_force.eigen())
    return "the hand's force differs";
  if (graph.device->effort_sent->head<6>() != straight.effort_sent) return "the effort differs";
  return "";
}

/// Both side by side until the hand leans on the wall, the straight one's last effort included.
std::string first_difference() {
  FeelAWall graph;
  StraightLaparoscope straight(settings_as_in(graph));
  bool touched = false;
  for (int i = 0; i < ticks; ++i) {
    graph.tick();
    straight.tick();
    touched = touched || straight.contact.load > 0.0;
    if (std::string what = difference(graph, straight); !what.empty())
      return what + " at tick " + std::to_string(i);
  }
  return touched ? "" : "the wall was never touched";
}

/// An iteration is a run from the beginning, so that both go through the same motion.
void run_ticks(benchmark::State& state, const auto& make) {
  static const std::string wrong = first_difference();
  if (!wrong.empty()) return state.SkipWithError(wrong.c_str());
  for (auto _ : state) {
    state.PauseTiming();
    const auto one = make();
    state.ResumeTiming();
    for (int i = 0; i < ticks; ++i) one->tick();
  }
  state.SetItemsProcessed(state.iterations() * ticks);
}

void laparoscope_tick(benchmark::State& state) {
  run_ticks(state, [] { return std::make_unique<FeelAWall>(); });
}

void straight_laparoscope_tick(benchmark::State& state) {
  const StraightSettings settings = settings_as_in(FeelAWall());
  run_ticks(state, [&] { return std::make_unique<StraightLaparoscope>(settings); });
}

BENCHMARK(laparoscope_tick)->Unit(benchmark::kMillisecond);
BENCHMARK(straight_laparoscope_tick)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace trocar::bench
