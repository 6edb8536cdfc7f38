// SPDX-License-Identifier: Apache-2.0
// What it costs to hand over a row of 100 numbers, and whether a recorder keeps up:
//
//   bench_recording [SECONDS [RATE]]      60 s at 10 kHz by default, to a file in the current
//   folder
//
// Exit status 0 when no row was lost, else 1.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <stdexcept>

#include "framework/realtime/background_poller.hpp"
#include "framework/session.hpp"
#include "tests/benchmarks/numbers.hpp"

using namespace trocar;
using trocar::bench::Numbers;

namespace {

constexpr const char* log_name = "bench_recording.mcap";

/// [ns] for one row of 100 numbers, its head and one component's time: the median of 10,000 times a
/// hundred rows, so that what else the machine does does not count.
double time_of_a_write(int readers) {
  constexpr std::size_t row = sizeof(RowHeader) + 8 + 8 * Numbers::count;
  constexpr int at_once = 100;
  BroadcastRing ring(std::size_t{64} << 20, row);
  std::deque<BroadcastRing::Cursor> cursors;
  for (int i = 0; i < readers; ++i) cursors.emplace_back(ring);
  std::deque<BackgroundPoller> pollers;
  for (BroadcastRing::Cursor& cursor : cursors)
    pollers.emplace_back([&cursor] { return cursor.next().has_value(); });
  TimingHistogram times;
  for (int n = 0; n < 10'000; ++n) {
    const std::int64_t begin = monotonic_ns();
    for (int i = 0; i < at_once; ++i) {
      const std::span<std::byte> room = ring.begin(row);
      std::fill(room.begin(), room.end(), static_cast<std::byte>(i));
      ring.commit(0);
    }
    times.add(monotonic_ns() - begin);
  }
  return static_cast<double>(times.percentile(0.5)) / at_once;
}

int record(double seconds, double rate) {
  Registry types;
  types.add<Numbers>("Numbers", "bench", "100 numbers that change");
  SessionOptions options;
  options.record = log_name;
  options.black_box = BlackBoxOptions{};
  Session session(types, options);
  session.graph().add("Numbers", "numbers", {log_name, 1});
  const RunResult& result =
      session.run({.duration = seconds, .wiring = {.rate = rate}, .keep_rows = true}).result;
  session.finish();
  const auto us = [](std::int64_t ns) { return static_cast<double>(ns) * 1e-3; };
  fmt::print("{:g} s at {:g} Hz: {} rows handed over, {} slots skipped, {} refused by the ring\n",
             seconds, rate, result.main().loop.rows, result.main().loop.skipped,
             result.main().loop.rows_lost);
  fmt::print("  a tick took {:.2f} µs (median), {:.2f} µs (99 %)\n",
             us(result.main().loop.duration.percentile(0.5)),
             us(result.main().loop.duration.percentile(0.99)));
  for (const std::string& shortcoming : result.shortcomings)
    fmt::print("  not real-time: {}\n", shortcoming);
  for (const std::string& lost : result.lost) fmt::print("  LOST: {}\n", lost);
  for (const ReaderLoss& loss : result.missed) fmt::print("  MISSED: {}\n", loss.text());
  if (result.missed.empty())
    fmt::print("  no reader missed anything; {} rows were kept for the experiment\n",
               result.rows->rows());
  fmt::print("  {} has {:.1f} MB\n", log_name,
             static_cast<double>(std::filesystem::file_size(log_name)) * 1e-6);
  return session.sound() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 60.0;
  const double rate = argc > 2 ? std::atof(argv[2]) : 1e4;
  if (!(seconds > 0.0) || !(rate >= 1.0)) {
    std::fputs("usage: bench_recording [SECONDS [RATE]]\n", stderr);
    return 2;
  }
  for (const int readers : {0, 3})
    fmt::print(
        "a row of {} numbers is handed over in {:.0f} ns, filling it included, with {} "
        "readers\n",
        Numbers::count, time_of_a_write(readers), readers);
  const int status = record(seconds, rate);
  std::filesystem::remove(log_name);
  return status;
}
