// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>

#include "cli/bench_result.hpp"
#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/script_options.hpp"
#include "cli/timing_options.hpp"
#include "framework/units.hpp"

namespace trocar::cli {
namespace {

constexpr int most_rounds = 1000;
constexpr double longest_round = 600.0;  // [s]
constexpr double fewest_slots = 100.0;   // of a round, or there is no 99 %

struct Arguments {
  std::string rounds = "20";
  std::string round_time = "1s";
  std::vector<std::string> rates = {"1kHz", "4kHz", "10kHz"};
  WaitOptions wait;
  std::string csv;
  std::string json;
};

double rate_of(const std::string& text) {
  try {
    const Quantity quantity = parse_quantity(text);
    if (quantity.unit.dimension == parse_unit("Hz").dimension && quantity.value >= 1.0 &&
        quantity.value <= 1e5)
      return quantity.value;
  } catch (const UnitError&) {
  }
  throw CLI::ValidationError("--rates",
                             in_quotes(text) + " is no rate, e.g. 1kHz or 250Hz (1 Hz to 100 kHz)");
}

int rounds_of(const std::string& text) {
  int rounds = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, rounds);
  if (read.ec == std::errc() && read.ptr == end && rounds >= 1 && rounds <= most_rounds)
    return rounds;
  throw CLI::ValidationError("--rounds",
                             in_quotes(text) + " is no number of rounds: 1 to 1000 are possible");
}

BenchResult prepared(const Arguments& arguments) {
  BenchResult bench;
  bench.rounds_wanted = rounds_of(arguments.rounds);
  bench.round_time = duration_of(arguments.round_time, "--round-time");
  if (bench.round_time > longest_round)
    throw CLI::ValidationError("--round-time", in_quotes(arguments.round_time) +
                                                   " is longer than the 600 s that are possible");
  arguments.wait.apply(bench.timing);
  for (const std::string& text : arguments.rates) {
    const double rate = rate_of(text);
    if (rate * bench.round_time < fewest_slots)
      throw CLI::ValidationError(
          "--round-time",
          fmt::format("{} has {:.3g} slots at {:.6g} Hz: at least {:.0f} are needed",
                      in_quotes(arguments.round_time), rate * bench.round_time, rate,
                      fewest_slots));
    const std::string wrong =
        check_spin(std::llround(bench.timing.spin * 1e9), std::llround(1e9 / rate));
    if (!wrong.empty()) throw CLI::ValidationError("--spin", wrong);
    bench.rates.push_back({.rate = rate});
  }
  return bench;
}

/// One line on a terminal, rewritten for each loop of each round.
class BenchProgress {
 public:
  explicit BenchProgress(const BenchResult& bench) : bench_(bench) {}
  ~BenchProgress() {
    if (shown_) fmt::print(stderr, "\r\033[K");
  }
  BenchProgress(const BenchProgress&) = delete;
  BenchProgress& operator=(const BenchProgress&) = delete;

  void show(int round, double rate, const char* loop) {
    const double all = 2.0 * bench_.rounds_wanted * static_cast<double>(bench_.rates.size());
    const double left = (all - static_cast<double>(done_++)) * bench_.round_time;
    if (isatty(STDERR_FILENO) == 0) return;
    fmt::print(stderr, "\r  round {} of {}: {} at {:.6g} Hz; {:.0f} s left, Ctrl-C ends it\033[K",
               round + 1, bench_.rounds_wanted, loop, rate, std::ceil(left));
    std::fflush(stderr);
    shown_ = true;
  }

 private:
  const BenchResult& bench_;
  int done_ = 0;
  bool shown_ = false;
};

void note_shortcomings(const LoopRound& round, BenchResult& bench) {
  for (const std::string& one : round.shortcomings)
    if (std::find(bench.shortcomings.begin(), bench.shortcomings.end(), one) ==
        bench.shortcomings.end())
      bench.shortcomings.push_back(one);
}

/// The loops take turns in going first, so that what a round leaves behind meets both.
/// @return whether the pair is whole
bool measure_pair(BenchResult& bench, RateRounds& rate, int round, const StopFlag& stop,
                  BenchProgress& progress) {
  const LoopTask task{rate.rate, bench.round_time, bench.timing, &stop};
  LoopRound bare, own;
  for (const bool is_bare : {round % 2 == 0, round % 2 == 1}) {
    progress.show(round, rate.rate, is_bare ? "the bare loop" : "Trocar's loop");
    LoopRound& one = is_bare ? bare : own;
    one = is_bare ? bare_round(task, bench.grants) : trocar_round(task);
    if (!one.complete) return false;
    note_shortcomings(one, bench);
  }
  rate.bare.push_back(std::move(bare));
  rate.trocar.push_back(std::move(own));
  return true;
}

void measure(BenchResult& bench, const StopFlag& stop) {
  BenchProgress progress(bench);
  bench.machine = machine_facts();
  const ProcessorTimes begin = ProcessorTimes::now();
  for (int round = 0; round < bench.rounds_wanted && !bench.interrupted; ++round)
    for (RateRounds& rate : bench.rates)
      if (!bench.interrupted) bench.interrupted = !measure_pair(bench, rate, round, stop, progress);
  bench.load = load_between(begin, ProcessorTimes::now());
}

void write(const std::string& path, const std::string& text) {
  if (path == "-") return print(text);
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.flush();
  if (!file) throw std::runtime_error(fmt::format("bench: cannot write {}", in_quotes(path)));
}

int run_bench(const Arguments& arguments) {
  BenchResult bench = prepared(arguments);
  if (arguments.csv == "-" && arguments.json == "-")
    throw CLI::ValidationError("--csv", "only one of --csv and --json can go to standard output");
  // Before minutes are spent on it.
  for (const std::string* path : {&arguments.csv, &arguments.json})
    if (!path->empty()) write(*path, "");
  measure(bench, stop_on_interrupt());
  if (bench.empty()) {
    complain("bench: stopped by the operator before a round was complete");
    return failed;
  }
  if (arguments.csv != "-" && arguments.json != "-") print(bench_text(bench));
  if (!arguments.csv.empty()) write(arguments.csv, bench_csv(bench));
  if (!arguments.json.empty()) write(arguments.json, bench_json(bench));
  return success;
}

}  // namespace

void add_bench(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("bench", "Measure how punctual loops are on this machine");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("--rates", arguments->rates, "Of the loops (default 1kHz,4kHz,10kHz)")
      ->delimiter(',')
      ->default_str("");
  command->add_option("--rounds", arguments->rounds, "For each rate (default 20)");
  command->add_option("--round-time", arguments->round_time,
                      "Of each loop in each round (default 1s)");
  arguments->wait.add_to(*command);
  command->add_option("--csv", arguments->csv,
                      "Write the histograms of lateness to this file, - for stdout");
  command->add_option("--json", arguments->json,
                      "Write the report as JSON to this file, - for "
                      "stdout");
  command->footer(
      "Runs a bare clock_nanosleep loop and Trocar's own in turn and compares how late their\n"
      "ticks begin. Figures are medians over rounds. Ctrl-C ends it with what was measured.\n\n"
      "Example:\n  trocar bench --rates 1kHz --spin 100us");
  command->callback([arguments, &status] { status = run_bench(*arguments); });
}

}  // namespace trocar::cli
