// SPDX-License-Identifier: Apache-2.0
// What it costs to hand a Wrench to another thread by LatestSlot.
#include <benchmark/benchmark.h>

#include <cstring>
#include <limits>
#include <thread>

#include "framework/realtime/latest_slot.hpp"
#include "framework/realtime/stop_flag.hpp"
#include "framework/types.hpp"

namespace trocar::bench {
namespace {

constexpr std::int64_t any_time = std::numeric_limits<std::int64_t>::max();

/// A Wrench on its way; its first number says which one it is.
class Way {
 public:
  void write(double number) RT_SAFE {
    wrench_.force.x = number;
    slot_.store(++time_, std::as_bytes(std::span(&wrench_, 1)));
  }
  /// The number of the newest, or 0.
  double read() const RT_SAFE {
    Wrench wrench;
    return slot_.load(any_time, std::as_writable_bytes(std::span(&wrench, 1))) ? wrench.force.x
                                                                               : 0.0;
  }

 private:
  LatestSlot slot_{sizeof(Wrench)};
  Wrench wrench_;
  std::int64_t time_ = 0;
};

/// Back and forth between two threads that do nothing else: a write, its way to the other
/// processor's cache and a read, twice in each iteration.
void cross_thread_latest(benchmark::State& state) {
  Way there, back;
  StopFlag stop;
  std::thread echo([&] {
    for (double seen = 0.0; !stop.raised();) {
      const double number = there.read();
      if (number == seen) continue;
      seen = number;
      back.write(number);
    }
  });
  double number = 0.0;
  for (auto _ : state) {
    there.write(++number);
    while (back.read() != number) {
    }
  }
  stop.raise();
  echo.join();
  state.SetItemsProcessed(2 * state.iterations());
}

/// The same instructions where nobody else has the cache lines.
void latest_alone(benchmark::State& state) {
  Way way;
  double number = 0.0;
  for (auto _ : state) {
    way.write(++number);
    benchmark::DoNotOptimize(way.read());
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(cross_thread_latest)->UseRealTime();
BENCHMARK(latest_alone);

}  // namespace
}  // namespace trocar::bench
