// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/preflight.hpp"
#include "cli/text_table.hpp"

namespace trocar::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr double percentile = 0.99;

std::string us_text(std::int64_t ns) {
  return fmt::format("{:.1f}", static_cast<double>(ns) * 1e-3);
}

std::string time_text(double seconds) {
  return fmt::format("{:.3f} s", seconds);
}

std::vector<std::string> cost_cells(const std::string& name, const StepCost& cost,
                                    const TimingHistogram& times, double rate) {
  const bool again = cost.worst_tick >= 0;
  return {name, times.count() == 0 ? "-" : us_text(times.percentile(percentile)),
          again ? us_text(cost.worst_ns) : "-",
          again ? time_text(static_cast<double>(cost.worst_tick) / rate) : "-",
          cost.steps == 0 ? "-" : us_text(cost.first_ns)};
}

std::string thread_text(const ThreadResult& thread) {
  TextTable table("lrrrrr");
  table.row({"step [µs]", "99 %", "worst", "at", "first", "allocations"});
  for (const ComponentTiming& component : thread.components) {
    std::vector<std::string> cells =
        cost_cells(component.name, component.cost, component.time, thread.rate);
    cells.push_back(fmt::format("{}", component.cost.allocations));
    table.row(std::move(cells));
  }
  std::vector<std::string> whole =
      cost_cells(fmt::format("tick, of {:.6g}", 1e6 / thread.rate), thread.loop.tick_cost,
                 thread.loop.duration, thread.rate);
  whole.emplace_back("");
  table.row(std::move(whole));
  return fmt::format("thread {}, {:.6g} Hz, {}\n", thread.name, thread.rate,
                     counted(static_cast<std::uint64_t>(thread.loop.ticks), "tick")) +
         table.text();
}

std::string peaks_text(const std::vector<RunPeak>& peaks) {
  TextTable table("lrrr");
  table.row({"peak", "", "at", "limit"});
  for (const RunPeak& peak : peaks)
    table.row({peak.name, fmt::format("{:.4g} {}", peak.value, peak.unit), time_text(peak.time),
               peak.limit ? fmt::format("{:.4g} {}", *peak.limit, peak.unit) : ""});
  return peaks.empty() ? "" : "\n" + table.text();
}

std::string laws_text(const std::vector<RunPeak>& laws) {
  TextTable table("lrr");
  table.row({"law", "most in a tick", "at"});
  for (const RunPeak& law : laws)
    table.row({law.name,
               law.name.ends_with(".memory") ? byte_text(static_cast<std::uint64_t>(law.value))
                                             : fmt::format("{:.0f}", law.value),
               time_text(law.time)});
  return laws.empty() ? "" : "\n" + table.text();
}

std::string list_text(const char* title, const std::vector<std::string>& list) {
  std::string text = list.empty() ? "" : fmt::format("\n{}\n", title);
  for (const std::string& one : list) text += wrapped(one, 2);
  return text;
}

double seconds(std::int64_t ns) {
  return static_cast<double>(ns) * 1e-9;
}

Json cost_json(const StepCost& cost, const TimingHistogram& times, double rate) {
  const bool again = cost.worst_tick >= 0;
  return {{"p99", seconds(times.percentile(percentile))},
          {"worst", again ? Json(seconds(cost.worst_ns)) : Json()},
          {"worst_at", again ? Json(static_cast<double>(cost.worst_tick) / rate) : Json()},
          {"first", seconds(cost.first_ns)}};
}

Json peaks_json(const std::vector<RunPeak>& peaks) {
  Json list = Json::array();
  for (const RunPeak& peak : peaks) {
    list.push_back(
        {{"name", peak.name}, {"unit", peak.unit}, {"peak", peak.value}, {"at", peak.time}});
    if (peak.limit) list.back()["limit"] = *peak.limit;
  }
  return list;
}

}  // namespace

std::string preflight_text(const Preflight& preflight) {
  std::string text = fmt::format("{:.6g} s in virtual time\n", preflight.run.duration);
  for (const ThreadResult& thread : preflight.run.threads) text += "\n" + thread_text(thread);
  text += peaks_text(preflight.peaks) + laws_text(preflight.laws);
  const std::vector<std::string> failures = preflight.failures();
  return text + list_text("Warnings", preflight.warnings()) + list_text("Failures", failures) +
         (failures.empty() ? "\nNothing would trip.\n" : "");
}

nlohmann::ordered_json preflight_json(const Preflight& preflight) {
  Json threads = Json::array();
  for (const ThreadResult& thread : preflight.run.threads) {
    Json components = Json::array();
    for (const ComponentTiming& component : thread.components) {
      Json one = {{"name", component.name}};
      one.update(cost_json(component.cost, component.time, thread.rate));
      one["allocations"] = component.cost.allocations;
      components.push_back(std::move(one));
    }
    threads.push_back(
        {{"name", thread.name},
         {"period", 1.0 / thread.rate},
         {"ticks", thread.loop.ticks},
         {"tick", cost_json(thread.loop.tick_cost, thread.loop.duration, thread.rate)},
         {"components", std::move(components)}});
  }
  const std::vector<std::string> failures = preflight.failures();
  return {{"duration", preflight.run.duration},
          {"threads", std::move(threads)},
          {"peaks", peaks_json(preflight.peaks)},
          {"laws", peaks_json(preflight.laws)},
          {"warnings", preflight.warnings()},
          {"failures", failures},
          {"sound", failures.empty()}};
}

}  // namespace trocar::cli
