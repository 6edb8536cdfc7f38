// SPDX-License-Identifier: Apache-2.0
// What it costs to read a value of the same thread through a port, beside plain memory.
#include <benchmark/benchmark.h>

#include <deque>
#include <numeric>
#include <vector>

#include "tests/benchmarks/bench_graph.hpp"

namespace trocar::bench {
namespace {

constexpr int reads = 64;

/// Counts up, so that no value is known beforehand.
class Counter final : public Component {
 public:
  void step(const Tick& tick) RT_SAFE override { *count = tick.index; }
  Output<std::int64_t> count{this, "count", {}};
};

/// Adds up whole numbers: an addition takes one cycle, and hides no read.
class Adder final : public Component {
 public:
  Adder() {
    for (int i = 0; i < reads; ++i)
      inputs_.emplace_back(this, "in" + std::to_string(i), PortOptions{.optional = true});
  }
  void step(const Tick&) RT_SAFE override {
    std::int64_t total = 0;
    for (const Input<std::int64_t>& input : inputs_) total += *input;
    *sum = total;
  }
  Output<std::int64_t> sum{this, "sum", {}};

 private:
  std::deque<Input<std::int64_t>> inputs_;
};

void same_thread_port(benchmark::State& state) {
  BenchGraph bench;
  bench.types.add<Counter>("Counter", "bench", "counts");
  bench.types.add<Adder>("Adder", "bench", "adds");
  const NodeId adder = bench.add("Adder");
  for (int i = 0; i < reads; ++i)
    bench.connect({bench.add("Counter", "counter" + std::to_string(i)), "count"},
                  {adder, "in" + std::to_string(i)});
  bench.start();
  bench.tick();
  Component& reader = *bench.wired->component(adder);
  for (auto _ : state) {
    reader.step({});
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * reads);
}

[[gnu::noinline]] void add_up(const std::vector<std::int64_t>& values, std::int64_t& sum) {
  sum = std::accumulate(values.begin(), values.end(), std::int64_t{0});
}

void plain_memory(benchmark::State& state) {
  std::vector<std::int64_t> values(reads, 1);
  std::int64_t sum = 0;
  for (auto _ : state) {
    add_up(values, sum);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * reads);
}

BENCHMARK(same_thread_port);
BENCHMARK(plain_memory);

}  // namespace
}  // namespace trocar::bench
