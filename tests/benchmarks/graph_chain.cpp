// SPDX-License-Identifier: Apache-2.0
// What a graph costs beside the same steps called by hand, one after the other. The last one's
// value goes back to the first in the next tick: else a processor would begin the next tick before
// this one has ended, which in a loop that waits for its slots it cannot.
#include <benchmark/benchmark.h>

#include <vector>

#include "tests/benchmarks/bench_graph.hpp"

namespace trocar::bench {
namespace {

/// A wrench, moved along a lever and weighed; 21 flops:
///
///   f' = g f + b          [N]
///   m' = g (m + r x f)    [N m]
///
/// g < 1 and b keep a chain of any length at ordinary numbers.
struct Lever {
  double gain = 0.5;                  // g
  Vector3 arm{0.01, 0.02, 0.03};      // r [m]
  Vector3 bias{0.125, 0.25, 0.0625};  // b [N]

  Wrench of(const Wrench& in) const RT_SAFE {
    const Vector3& f = in.force;
    const Vector3& m = in.moment;
    return {{gain * f.x + bias.x, gain * f.y + bias.y, gain * f.z + bias.z},
            {gain * (m.x + (arm.y * f.z - arm.z * f.y)), gain * (m.y + (arm.z * f.x - arm.x * f.z)),
             gain * (m.z + (arm.x * f.y - arm.y * f.x))}};
  }
};

/// @tparam feedthrough false for the first, which reads what the last one wrote a tick ago
template <bool feedthrough>
class LeverStep final : public Component {
 public:
  void step(const Tick&) RT_SAFE override { *output = lever_.of(*input); }

  Input<Wrench> input{this, "input", {.unit = "N, N m", .feedthrough = feedthrough}};
  Output<Wrench> output{this, "output", {.unit = "N, N m"}};

 private:
  Lever lever_;
};

/// The same by hand: two pointers and the law. Values lie one behind the other, as a graph's do.
struct HandStep {
  const Wrench* input;
  Wrench* output;
  Lever lever;
};

[[gnu::noinline]] void step(const HandStep& one) RT_SAFE {
  *one.output = one.lever.of(*one.input);
}

class HandChain {
 public:
  explicit HandChain(std::size_t length) : values_(length) {
    for (std::size_t i = 0; i < length; ++i)
      steps_.push_back({&values_[(i + length - 1) % length], &values_[i], {}});
  }
  HandChain(const HandChain&) = delete;
  HandChain& operator=(const HandChain&) = delete;
  void tick() RT_SAFE {
    for (const HandStep& one : steps_) step(one);
  }
  const Wrench& end() const { return values_.back(); }

 private:
  std::vector<Wrench> values_;
  std::vector<HandStep> steps_;
};

class GraphChain {
 public:
  GraphChain(std::size_t length, bool timing) {
    bench_.types.add<LeverStep<false>>("FirstLever", "bench", "moves a wrench along a lever");
    bench_.types.add<LeverStep<true>>("Lever", "bench", "moves a wrench along a lever");
    const NodeId first = bench_.add("FirstLever");
    NodeId last = first;
    for (std::size_t i = 1; i < length; ++i) {
      const NodeId node = bench_.add("Lever", "lever" + std::to_string(i));
      bench_.connect({last, "output"}, {node, "input"});
      last = node;
    }
    bench_.connect({last, "output"}, {first, "input"});
    bench_.start(timing);
    end_ = reinterpret_cast<const Wrench*>(
        bench_.wired->component(last)->find_output("output")->data());
  }
  void tick() { bench_.tick(); }
  const Wrench& end() const { return *end_; }

 private:
  BenchGraph bench_;
  const Wrench* end_ = nullptr;
};

void run_chain(benchmark::State& state, auto& chain) {
  const auto length = state.range(0);
  HandChain expected(static_cast<std::size_t>(length));
  for (int i = 0; i < 3; ++i) {
    expected.tick();
    chain.tick();
  }
  if (chain.end().eigen() != expected.end().eigen())
    return state.SkipWithError("the chain does not compute what the one by hand does");
  for (auto _ : state) {
    chain.tick();
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * length);
}

void handwritten_chain(benchmark::State& state) {
  HandChain chain(static_cast<std::size_t>(state.range(0)));
  run_chain(state, chain);
}

void graph_chain(benchmark::State& state) {
  GraphChain chain(static_cast<std::size_t>(state.range(0)), false);
  run_chain(state, chain);
}

void graph_chain_timed(benchmark::State& state) {
  GraphChain chain(static_cast<std::size_t>(state.range(0)), true);
  run_chain(state, chain);
}

void lengths(benchmark::internal::Benchmark* bench) {
  for (const int length : {1, 8, 16, 64, 1000}) bench->Arg(length);
}

BENCHMARK(handwritten_chain)->Apply(lengths);
BENCHMARK(graph_chain)->Apply(lengths);
BENCHMARK(graph_chain_timed)->Apply(lengths);

}  // namespace
}  // namespace trocar::bench
