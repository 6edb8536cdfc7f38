// SPDX-License-Identifier: Apache-2.0
// What simulating the laparoscope costs, a hand at its tool included.
#include <benchmark/benchmark.h>

#include "components/devices/laparoscope_plant.hpp"

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

BENCHMARK(plant_step);

}  // namespace
}  // namespace trocar::bench
