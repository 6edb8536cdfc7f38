// SPDX-License-Identifier: Apache-2.0
#include "cli/bench_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace trocar::cli {
namespace {

using Json = nlohmann::ordered_json;

Json loop_json(const std::vector<LoopRound>& rounds) {
  const LoopTotal total = total_of(rounds);
  Json json = Json::object();
  for (const LatenessFigure& figure : lateness_figures) {
    const OverRounds value = over_rounds(rounds, figure.share);
    Json each = Json::array();
    for (const LoopRound& round : rounds)
      each.push_back(static_cast<double>(round.lateness.percentile(figure.share)) * 1e-9);
    json[figure.key] = {{"median", value.median},
                        {"least", value.least},
                        {"greatest", value.greatest},
                        {"rounds", each}};
  }
  json["slots"] = total.used;
  json["skipped"] = total.skipped;
  json["spun"] = total.spun;
  json["drift"] = total.drift;
  json["adds_up"] = total.adds_up;
  return json;
}

Json ratio_json(const std::optional<PairRatio>& ratio) {
  if (!ratio) return {};
  Json json = {{"median", ratio->median}};
  if (ratio->interval) json["interval"] = {ratio->interval->first, ratio->interval->second};
  return json;
}

Json rate_json(const RateRounds& rounds) {
  Json json = {{"rate", rounds.rate},
               {"rounds", rounds.bare.size()},
               {"bare", loop_json(rounds.bare)},
               {"trocar", loop_json(rounds.trocar)}};
  for (const LatenessFigure& figure : lateness_figures)
    json["ratio"][figure.key] = ratio_json(ratio_over_pairs(rounds, figure.share));
  return json;
}

double seconds_of(const LoopRound& round, double share) {
  return static_cast<double>(round.lateness.percentile(share)) * 1e-9;
}

double median_of(const std::vector<double>& sorted) {
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

/// The largest rank r, from 1, for which P(Binomial(n, 1/2) < r) <= 2.5 %; 0 where there is none.
std::size_t interval_rank(std::size_t n) {
  double term = std::pow(0.5, static_cast<double>(n));  // P(Binomial = k), here for k = 0
  double below = 0.0;
  std::size_t rank = 0;
  while (rank < n && below + term <= 0.025) {
    below += term;
    term *= static_cast<double>(n - rank) / static_cast<double>(rank + 1);
    ++rank;
  }
  return rank;
}

}  // namespace

bool BenchResult::empty() const {
  return std::all_of(rates.begin(), rates.end(),
                     [](const RateRounds& one) { return one.trocar.empty(); });
}

OverRounds over_rounds(const std::vector<LoopRound>& rounds, double share) {
  if (rounds.empty()) return {};
  std::vector<double> values;
  for (const LoopRound& round : rounds) values.push_back(seconds_of(round, share));
  std::sort(values.begin(), values.end());
  return {median_of(values), values.front(), values.back()};
}

std::optional<PairRatio> ratio_over_pairs(const RateRounds& rounds, double share) {
  if (rounds.trocar.empty() || over_rounds(rounds.bare, share).median < 1e-6) return {};
  std::vector<double> ratios;
  for (std::size_t i = 0; i < rounds.trocar.size(); ++i)
    ratios.push_back(seconds_of(rounds.trocar[i], share) /
                     std::max(1e-9, seconds_of(rounds.bare[i], share)));
  std::sort(ratios.begin(), ratios.end());
  PairRatio ratio{.median = median_of(ratios)};
  if (const std::size_t rank = interval_rank(ratios.size()); rank > 0)
    ratio.interval = {ratios[rank - 1], ratios[ratios.size() - rank]};
  return ratio;
}

LoopTotal total_of(const std::vector<LoopRound>& rounds) {
  LoopTotal total;
  for (const LoopRound& round : rounds) {
    total.lateness.add(round.lateness);
    total.used += round.used;
    total.skipped += round.skipped;
    total.spun += round.spun / static_cast<double>(rounds.size());
    total.drift = std::max(total.drift, std::abs(round.drift()));
    total.adds_up = total.adds_up && round.adds_up();
  }
  return total;
}

std::string bench_json(const BenchResult& result) {
  Json machine = Json::object();
  for (const MachineFact& fact : result.machine) machine[fact.key] = fact.value;
  machine["load_meanwhile"] = result.load;
  machine["fifo"] = result.grants.fifo;
  machine["priority"] = result.grants.priority;
  machine["timer_slack_ns"] = result.grants.timer_slack_ns;
  machine["locked_kib"] = result.grants.locked_kib;
  Json rates = Json::array();
  for (const RateRounds& one : result.rates)
    if (!one.trocar.empty()) rates.push_back(rate_json(one));
  const Json all = {
      {"rounds", result.rounds_wanted},      {"round_time", result.round_time},
      {"spin", result.timing.spin},          {"hold_latency", result.timing.hold_latency},
      {"interrupted", result.interrupted},   {"machine", machine},
      {"shortcomings", result.shortcomings}, {"rates", rates}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string bench_csv(const BenchResult& result) {
  std::string text = "loop,rate_hz,lower_ns,upper_ns,count\n";
  for (const RateRounds& one : result.rates)
    for (const auto& [name, rounds] : {std::pair("bare", &one.bare), {"trocar", &one.trocar}})
      for (const TimingHistogram::Bin& bin : total_of(*rounds).lateness.bins())
        text +=
            fmt::format("{},{:.10g},{},{},{}\n", name, one.rate, bin.lower, bin.upper, bin.count);
  return text;
}

}  // namespace trocar::cli
