// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "cli/bench_result.hpp"
#include "cli/text_table.hpp"

namespace trocar::cli {
namespace {

std::string us_text(double seconds) {
  const double us = seconds * 1e6;
  return us < 100.0 ? fmt::format("{:.1f}", us) : fmt::format("{:.0f}", us);
}

std::string interval_text(const std::optional<PairRatio>& ratio) {
  if (!ratio || !ratio->interval) return "-";
  return fmt::format("{:.2f} to {:.2f}", ratio->interval->first, ratio->interval->second);
}

std::string rate_name(double rate) {
  return rate >= 1000.0 ? fmt::format("{:.6g} kHz", rate * 1e-3) : fmt::format("{:.6g} Hz", rate);
}

std::string drift_text(const char* name, const std::vector<LoopRound>& rounds) {
  const LoopTotal total = total_of(rounds);
  const std::string sum = fmt::format("{}: elapsed time is {} used and {} skipped", name,
                                      counted(static_cast<std::uint64_t>(total.used), "slot"),
                                      counted(static_cast<std::uint64_t>(total.skipped), "slot"));
  const char* verdict = total.adds_up ? "{}, to {:.3f} of a period, which the lateness explains: "
                                        "no drift"
                                      : "{} only to {:.3f} of a period, more than the lateness "
                                        "explains: IT DRIFTS";
  return wrapped(fmt::format(fmt::runtime(verdict), sum, total.drift), 2);
}

std::string rate_text(const RateRounds& one, const LoopTiming& timing) {
  TextTable table("lrrrrr");
  table.row({"lateness [µs]", "bare loop", "in its rounds", "Trocar", "Trocar / bare", "95 %"});
  for (const LatenessFigure& figure : lateness_figures) {
    const OverRounds bare = over_rounds(one.bare, figure.share);
    const OverRounds own = over_rounds(one.trocar, figure.share);
    const std::optional<PairRatio> ratio = ratio_over_pairs(one, figure.share);
    table.row({figure.label, us_text(bare.median),
               us_text(bare.least) + " to " + us_text(bare.greatest), us_text(own.median),
               ratio ? fmt::format("{:.2f}", ratio->median) : "-", interval_text(ratio)});
  }
  const LoopTotal bare = total_of(one.bare), own = total_of(one.trocar);
  table.row({"slots missed", fmt::format("{}", bare.skipped), "", fmt::format("{}", own.skipped),
             "", ""});
  if (timing.spin > 0.0)
    table.row({"guard spin [% of a processor]", fmt::format("{:.1f}", 100.0 * bare.spun), "",
               fmt::format("{:.1f}", 100.0 * own.spun), "", ""});
  return fmt::format("\n{}, a period of {} µs, {}\n", rate_name(one.rate), us_text(1.0 / one.rate),
                     counted(one.trocar.size(), "round")) +
         table.text() + drift_text("bare loop", one.bare) + drift_text("Trocar", one.trocar);
}

std::string machine_text(const BenchResult& result) {
  const LoopGrants& grants = result.grants;
  TextTable table("ll");
  for (const MachineFact& fact : result.machine) table.row({fact.label, fact.value});
  table.row({"processors meanwhile", result.load});
  table.row({"real-time priority", grants.fifo ? fmt::format("SCHED_FIFO {}", grants.priority)
                                               : "not granted: ordinary scheduling"});
  table.row({"memory", grants.locked_kib > 0
                           ? fmt::format("locked, {} MB", grants.locked_kib / 1024)
                           : "not locked: the loop may wait for pages"});
  table.row({"timer slack", fmt::format("{} ns", grants.timer_slack_ns)});
  const bool refused = std::any_of(
      result.shortcomings.begin(), result.shortcomings.end(),
      [](const std::string& text) { return text.find("cpu_dma_latency") != std::string::npos; });
  table.row({"/dev/cpu_dma_latency", !result.timing.hold_latency ? "left alone (--hold-latency)"
                                     : refused                   ? "not granted, see below"
                                                                 : "held at 0: no deep sleep"});
  std::string text = "\nThe machine\n" + table.text();
  for (const std::string& one : result.shortcomings) text += wrapped("not real-time: " + one, 2);
  return text;
}

constexpr const char* explanation =
    "Lateness is how long after its slot a tick begins. The bare loop is the least that a loop can "
    "be on this machine: it sleeps until the slot, looks at the time, and does nothing. Figures in "
    "µs are medians over all rounds of what a round had; single samples are known to 6 %. Trocar / "
    "bare tells what Trocar adds: the median over all pairs of rounds of their ratio, with the "
    "interval in which it lies with 95 %. An interval that holds 1.00 shows no difference; more "
    "rounds narrow it. Below 1 µs and 6 rounds it says nothing. A tick that begins late acts on an "
    "old position: compare the 99 % with the delay that your device and controller tolerate, and "
    "the worst with the period.";

}  // namespace

std::string bench_text(const BenchResult& result) {
  std::string text = wrapped(
      fmt::format(
          "How late loops begin: {} of {:.6g} s a rate, a bare loop and Trocar's in turn{}",
          counted(static_cast<std::uint64_t>(result.rounds_wanted), "round"), result.round_time,
          result.timing.spin > 0.0
              ? fmt::format(", both with a guard spin of {:.6g} µs", result.timing.spin * 1e6)
              : ""),
      0);
  if (result.interrupted) text += "Stopped by the operator; this is what was measured by then.\n";
  for (const RateRounds& one : result.rates)
    if (!one.trocar.empty()) text += rate_text(one, result.timing);
  return text + machine_text(result) + "\n" + wrapped(explanation, 0);
}

}  // namespace trocar::cli
