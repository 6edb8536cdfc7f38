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

Json rate_json(const RateRounds& rounds) {
  Json json = {{"rate", rounds.rate},
               {"rounds", rounds.bare.size()},
               {"bare", loop_json(rounds.bare)},
               {"trocar", loop_json(rounds.trocar)}};
  for (const LatenessFigure& figure : lateness_figures) {
    const double bare = over_rounds(rounds.bare, figure.share).median;
    const double own = over_rounds(rounds.trocar, figure.share).median;
    json["ratio"][figure.key] = bare > 0.0 ? Json(own / bare) : Json();
  }
  return json;
}

}  // namespace

bool BenchResult::empty() const {
  return std::all_of(rates.begin(), rates.end(),
                     [](const RateRounds& one) { return one.trocar.empty(); });
}

OverRounds over_rounds(const std::vector<LoopRound>& rounds, double share) {
  if (rounds.empty()) return {};
  std::vector<double> values;
  for (const LoopRound& round : rounds)
    values.push_back(static_cast<double>(round.lateness.percentile(share)) * 1e-9);
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double median =
      values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  return {median, values.front(), values.back()};
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
