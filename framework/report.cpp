// SPDX-License-Identifier: Apache-2.0
#include "framework/report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "framework/text.hpp"

namespace trocar {
namespace {

/// A length as people think of it, forces as they are.
double shown(const Highlight& one, double value) {
  return one.is_force ? value : 1e3 * value;
}
const char* shown_unit(const Highlight& one) {
  return one.is_force ? "N" : "mm";
}

/// "laparoscope.tool.tip" is the tip to whoever looks.
std::string short_name(const Highlight& one) {
  if (one.is_force) return one.name;
  const std::size_t dot = one.name.rfind('.');
  return dot == std::string::npos ? one.name : one.name.substr(dot + 1);
}

std::string vector_text(const Highlight& one, const Vector3& v) {
  const auto clean = [&](double value) {
    const double rounded = std::round(shown(one, value) * 100.0) / 100.0;
    return rounded == 0.0 ? 0.0 : rounded;  // no "-0.00"
  };
  return fmt::format("{:8.2f}{:8.2f}{:8.2f}", clean(v.x), clean(v.y), clean(v.z));
}

std::string moments_text(const Highlights& highlights) {
  if (highlights.all().empty()) return "";
  std::string text = fmt::format("  {:>8}", "time");
  std::string under = fmt::format("  {:>8}", "[s]");
  for (const Highlight& one : highlights.all()) {
    text += fmt::format("   {:<24}", short_name(one));
    under += fmt::format("   {:>7}x{:>7}y{:>6}z  ", fmt::format("[{}] ", shown_unit(one)), "", "");
  }
  text += "\n" + under + "\n";
  for (const Highlights::Moment& moment : highlights.moments()) {
    text += fmt::format("  {:8.2f}", moment.time);
    for (std::size_t i = 0; i < highlights.all().size(); ++i)
      text += "   " + vector_text(highlights.all()[i], moment.values[i]);
    text += "\n";
  }
  for (const Highlight& one : highlights.all())
    if (one.is_force)
      text += fmt::format("  largest {}: {:.2f} N at {:.2f} s, at the end {:.2f} N\n", one.name,
                          one.peak, one.peak_time, one.last.eigen().norm());
  return text;
}

std::string timing_text(const RunResult& result) {
  const auto us = [](const TimingHistogram& histogram, double share) {
    return static_cast<double>(histogram.percentile(share)) * 1e-3;
  };
  std::string text = fmt::format("  one tick took {:.1f} µs (median), {:.1f} µs (99 %)\n",
                                 us(result.loop.duration, 0.5), us(result.loop.duration, 0.99));
  if (result.clock == ClockKind::realtime)
    text += fmt::format(
        "  lateness {:.0f} µs (median), {:.0f} µs (99 %), {:.0f} µs (worst); {} slots "
        "missed\n",
        us(result.loop.lateness, 0.5), us(result.loop.lateness, 0.99),
        static_cast<double>(result.loop.lateness.max()) * 1e-3, result.loop.skipped);
  return text;
}

std::string run_text(const SessionRun& run) {
  const RunResult& result = run.result;
  std::string text = fmt::format(
      "{}{} ticks at {:.6g} Hz: {:.3f} s of {} time in {:.2f} s ({:.1f} × real time)\n",
      result.interrupted ? "stopped by the operator after " : "ran ", result.loop.ticks,
      result.rate, result.duration, result.clock == ClockKind::simulated ? "virtual" : "real",
      result.wall_time, result.wall_time > 0.0 ? result.duration / result.wall_time : 0.0);
  text += moments_text(run.highlights);
  text += timing_text(result);
  text += result.faults.empty()
              ? "  no faults\n"
              : fmt::format("  FAULT, first cause: {}\n", result.faults[0].text());
  for (std::size_t i = 1; i < result.faults.size(); ++i)
    text += fmt::format("  then: {}\n", result.faults[i].text());
  for (const std::string& shortcoming : result.shortcomings)
    text += fmt::format("  not real-time: {}\n", shortcoming);
  for (const std::string& lost : result.lost) text += fmt::format("  LOST: {}\n", lost);
  return text;
}

std::string published_text(const Session& session) {
  std::string text;
  for (const Published& one : session.published()) {
    std::vector<std::string> parts;
    if (const auto* table = one.row.as<Literal::Table>())
      for (const auto& [key, value] : *table)
        parts.push_back(fmt::format("{} = {}", key,
                                    value.as<double>() != nullptr
                                        ? fmt::format("{:.6g}", *value.as<double>())
                                        : value.text()));
    text += fmt::format("{}: {}\n", one.name, parts.empty() ? one.row.text() : join(parts, ", "));
  }
  return text;
}

}  // namespace

std::string report_text(const Session& session) {
  std::string text;
  std::int64_t rows = 0;
  std::int64_t lost = 0;
  for (std::size_t i = 0; i < session.runs().size(); ++i) {
    if (session.runs().size() > 1) text += fmt::format("run {}: ", i + 1);
    text += run_text(*session.runs()[i]);
    rows += session.runs()[i]->result.loop.rows;
    lost += session.runs()[i]->result.loop.rows_lost;
  }
  if (!session.log_path().empty())
    text += fmt::format("recorded {} rows to {}, {} lost\n", rows, session.log_path(), lost);
  text += published_text(session);
  for (const std::string& trouble : session.troubles()) text += "LOG: " + trouble + "\n";
  return text;
}

}  // namespace trocar
