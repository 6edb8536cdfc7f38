// SPDX-License-Identifier: Apache-2.0
// What a row costs the loop's thread: to gather its numbers and to hand it over.
#include <benchmark/benchmark.h>

#include <vector>

#include "framework/event.hpp"
#include "framework/realtime/background_poller.hpp"
#include "framework/realtime/broadcast_ring.hpp"
#include "framework/recording/row_layout.hpp"
#include "tests/benchmarks/bench_graph.hpp"
#include "tests/benchmarks/numbers.hpp"

namespace trocar::bench {
namespace {

/// One row of as many doubles as the argument says, while a reader takes the rows.
void row_capture(benchmark::State& state) {
  BenchGraph bench;
  bench.types.add<Numbers>("Numbers", "bench", "100 numbers that change");
  for (int i = 0; i < state.range(0) / Numbers::count; ++i)
    bench.add("Numbers", "numbers" + std::to_string(i));
  bench.start();
  const RateGroup& group = bench.wired->main();
  const RowLayout layout(group);
  BroadcastRing ring(std::size_t{64} << 20, layout.size());
  BroadcastRing::Cursor cursor(ring);
  BackgroundPoller reader([&cursor] { return cursor.next().has_value(); });
  const std::vector<std::int64_t> times(group.schedule().size(), 0);
  RowHeader header;
  for (auto _ : state) {
    ++header.tick;
    layout.capture(header, times, group.memory(), ring.begin(layout.size()));
    ring.commit(record_tag(RecordKind::row, 0));
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(row_capture)->Arg(Numbers::count);

}  // namespace
}  // namespace trocar::bench
