// SPDX-License-Identifier: Apache-2.0
// What simulating the laparoscope costs, with all its imperfections and a hand at its tool.
#include <benchmark/benchmark.h>

#include "components/devices/simulated_laparoscope.hpp"
#include "components/register.hpp"
#include "tests/benchmarks/bench_graph.hpp"

namespace trocar::bench {
namespace {

constexpr int steps = 10;  // of 0.1 ms: a tick at 1 kHz

void plant_step(benchmark::State& state) {
  LaparoscopePlant plant;
  for (auto _ : state) {
    plant.advance(1e-4 * steps, steps);
    benchmark::ClobberMemory();
  }
  if (plant.status() != AssemblyStatus::ok) state.SkipWithError(describe(plant.status()));
  state.SetItemsProcessed(state.iterations() * steps);
}

/// The device as a component, alone in its graph, with its gate: a hand carries its weight.
void plant_tick(benchmark::State& state) {
  BenchGraph bench;
  register_components(bench.types);
  const NodeId device = bench.add("SimulatedLaparoscope");
  for (const auto& [name, value] : {std::pair("hand", "push"),
                                    {"hand_stiffness", "2 N/mm"},
                                    {"push_distance", "20 mm"},
                                    {"push_dwell", "0 s"}})
    bench.graph.set({device, name}, literal_from_text(value), {});
  bench.start();
  for (auto _ : state) bench.tick();
  state.SetItemsProcessed(state.iterations());
  if (bench.executor->faults().latched()) state.SkipWithError("a fault");
}

BENCHMARK(plant_step);
BENCHMARK(plant_tick);

}  // namespace
}  // namespace trocar::bench
