// SPDX-License-Identifier: Apache-2.0
#include "framework/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "framework/text.hpp"

namespace trocar {
namespace {

constexpr std::size_t most_runs_listed = 20;
constexpr std::size_t widest = 80;  // [columns] of a terminal
constexpr std::size_t number_width = 8;

/// Lengths are in millimetres to people.
double shown(const Highlight& one, double value) {
  return one.is_force ? value : 1e3 * value;
}

/// "laparoscope.tool.tip" is the tip to whoever looks, "wall.force" the wall's.
std::string title(const Highlight& one) {
  const std::size_t dot = std::min(one.name.rfind('.'), one.name.size());
  return one.is_force ? fmt::format("force of {} [N]", one.name.substr(0, dot))
                      : fmt::format("{} [mm]", one.name.substr(std::min(dot + 1, one.name.size())));
}

std::string number_text(const Highlight& one, double value) {
  const double rounded = std::round(shown(one, value) * 100.0) / 100.0;
  return fmt::format("{:.2f}", rounded == 0.0 ? 0.0 : rounded);  // no "-0.00"
}

/// The columns of one vector in the table of moments: only axes that show something.
struct Block {
  std::size_t vector = 0;
  std::vector<std::pair<char, double Vector3::*>> axes{};
  std::size_t width = 0;
};

Block block_of(const Highlights& highlights, std::size_t vector,
               const std::vector<Highlights::Moment>& moments) {
  const Highlight& one = highlights.all()[vector];
  Block block{.vector = vector};
  for (const auto& axis : {std::pair('x', &Vector3::x), {'y', &Vector3::y}, {'z', &Vector3::z}})
    if (std::any_of(moments.begin(), moments.end(), [&](const Highlights::Moment& moment) {
          return number_text(one, moment.values[vector].*axis.second) != "0.00";
        }))
      block.axes.emplace_back(axis);
  block.width = std::max(title(one).size() + 3, block.axes.size() * number_width);
  return block;
}

/// As many vectors as fit a terminal.
std::vector<Block> blocks_of(const Highlights& highlights,
                             const std::vector<Highlights::Moment>& moments) {
  std::vector<Block> blocks;
  std::size_t width = 2 + number_width;
  for (std::size_t i = 0; i < highlights.all().size(); ++i) {
    Block block = block_of(highlights, i, moments);
    if (block.axes.empty() || width + block.width > widest) continue;
    width += block.width;
    blocks.push_back(std::move(block));
  }
  return blocks;
}

std::string moments_text(const Highlights& highlights) {
  const std::vector<Highlights::Moment> moments = highlights.moments();
  const std::vector<Block> blocks = blocks_of(highlights, moments);
  if (blocks.empty()) return "";
  std::string text = fmt::format("\n  {:>{}}", "time [s]", number_width);
  for (const Block& block : blocks)
    text += fmt::format("{:>{}}", title(highlights.all()[block.vector]), block.width);
  text += fmt::format("\n  {:>{}}", "", number_width);
  for (const Block& block : blocks) {
    std::string axes;
    for (const auto& axis : block.axes) axes += fmt::format("{:>{}}", axis.first, number_width);
    text += fmt::format("{:>{}}", axes, block.width);
  }
  for (const Highlights::Moment& moment : moments) {
    text += fmt::format("\n  {:{}.2f}", moment.time, number_width);
    for (const Block& block : blocks) {
      const Highlight& one = highlights.all()[block.vector];
      std::string numbers;
      for (const auto& axis : block.axes)
        numbers += fmt::format("{:>{}}", number_text(one, moment.values[block.vector].*axis.second),
                               number_width);
      text += fmt::format("{:>{}}", numbers, block.width);
    }
  }
  return text + "\n\n";
}

std::string peaks_text(const Highlights& highlights) {
  std::string text;
  for (const Highlight& one : highlights.all()) {
    if (!one.is_force) continue;
    const std::string name = one.name.substr(0, one.name.rfind('.'));
    if (one.peak == 0.0)
      text += fmt::format("  {} never pushed\n", name);
    else
      text += fmt::format("  {} pushed hardest at {:.2f} s, with {:.2f} N; at the end with {} N\n",
                          name, one.peak_time, one.peak, number_text(one, one.last.eigen().norm()));
  }
  return text;
}

/// What keeping the time took from the machine.
std::string cost_text(const RunResult& result) {
  std::string text;
  if (result.spin > 0.0 && result.wall_time > 0.0) {
    std::int64_t spun = 0;
    for (const ThreadResult& thread : result.threads) spun += thread.loop.spun_ns;
    text += fmt::format("  guard spin {:.6g} µs: {:.1f} % of a processor\n", result.spin * 1e6,
                        static_cast<double>(spun) * 1e-7 / result.wall_time);
  }
  if (result.latency_held)
    text += "  /dev/cpu_dma_latency was held at 0: no processor slept deeply, which costs power\n";
  return text;
}

std::string timing_text(const ThreadResult& thread, ClockKind clock) {
  const auto us = [](const TimingHistogram& histogram, double share) {
    return static_cast<double>(histogram.percentile(share)) * 1e-3;
  };
  std::string text = fmt::format("  one tick took {:.1f} µs (median), {:.1f} µs (99 %)\n",
                                 us(thread.loop.duration, 0.5), us(thread.loop.duration, 0.99));
  if (clock != ClockKind::simulated)
    text += fmt::format(
        "  lateness {:.0f} µs (median), {:.0f} µs (99 %), {:.0f} µs (worst); {} slots "
        "missed, {} overruns\n",
        us(thread.loop.lateness, 0.5), us(thread.loop.lateness, 0.99),
        static_cast<double>(thread.loop.lateness.max()) * 1e-3, thread.loop.skipped,
        thread.loop.overruns);
  return text;
}

/// Each thread says its name and rate where there are several.
std::string threads_text(const RunResult& result) {
  std::string text;
  for (const ThreadResult& thread : result.threads) {
    if (result.threads.size() > 1)
      text += fmt::format("  thread {}: {} ticks at {:.6g} Hz\n", thread.name, thread.loop.ticks,
                          thread.rate);
    text += timing_text(thread, result.clock);
  }
  return text + cost_text(result);
}

std::string faults_text(const RunResult& result) {
  std::string text = result.faults.empty() ? "  no faults\n" : "";
  for (std::size_t i = 0; i < result.faults.size(); ++i)
    text +=
        fmt::format("  {}: {}\n", i == 0 ? "FAULT, first cause" : "then", result.faults[i].text());
  for (const std::string& shortcoming : result.shortcomings)
    text += fmt::format("  not real-time: {}\n", shortcoming);
  for (const std::string& lost : result.lost) text += fmt::format("  LOST: {}\n", lost);
  for (const ReaderLoss& loss : result.missed)
    text += fmt::format("  {}: {}\n", loss.matters ? "MISSED" : "missed", loss.text());
  return text;
}

std::string reloads_text(const RunResult& result) {
  std::string text;
  for (const ReloadVerdict& verdict : result.reloads)
    text += fmt::format("  reload: {}\n", verdict.text());
  return text;
}

std::string captures_text(const CaptureResult& captured) {
  std::string text;
  for (const TriggeredFile& file : captured.files)
    text += fmt::format("  {}: {}, {:.3f} s to {:.3f} s: {}\n", file.writer, file.path, file.from,
                        file.to, file.cause);
  for (const std::string& note : captured.notes) text += "  " + note + "\n";
  return text;
}

std::string run_text(const SessionRun& run) {
  const RunResult& result = run.result;
  return fmt::format(
             "{}{} ticks at {:.6g} Hz: {:.3f} s of {} time in {:.2f} s ({:.1f} × real time)\n",
             result.interrupted ? "stopped by the operator after " : "ran ",
             result.main().loop.ticks, result.main().rate, result.duration,
             result.clock == ClockKind::simulated ? "virtual" : "real", result.wall_time,
             result.wall_time > 0.0 ? result.duration / result.wall_time : 0.0) +
         moments_text(run.highlights) + peaks_text(run.highlights) + threads_text(result) +
         faults_text(result) + reloads_text(result) + captures_text(run.captured);
}

/// Nothing of it needs a line of its own.
bool was_quiet(const RunResult& result) {
  return result.faults.empty() && result.shortcomings.empty() && result.lost.empty() &&
         result.missed.empty();
}

/// One of several runs: a line, and what went wrong.
std::string short_run_text(const SessionRun& run, std::size_t number) {
  const RunResult& result = run.result;
  std::string text =
      fmt::format("run {}: {:.3f} s at {:.6g} Hz", number, result.duration, result.main().rate);
  for (const Highlight& one : run.highlights.all())
    if (one.is_force)
      text += fmt::format(", {} up to {:.2f} N", one.name.substr(0, one.name.rfind('.')), one.peak);
  if (result.interrupted) text += ", stopped by the operator";
  return text + (was_quiet(result) ? ", no faults\n" : "\n" + faults_text(result)) +
         reloads_text(result) + captures_text(run.captured);
}

/// What they took together, and lines for those in which something happened.
std::string many_runs_text(const Session& session) {
  double duration = 0.0, wall_time = 0.0;
  std::size_t with_faults = 0;
  std::string lines;
  for (std::size_t i = 0; i < session.runs().size(); ++i) {
    const SessionRun& run = *session.runs()[i];
    const RunResult& result = run.result;
    duration += result.duration;
    wall_time += result.wall_time;
    with_faults += result.faults.empty() ? 0 : 1;
    if (!was_quiet(result) || result.interrupted || !result.reloads.empty() ||
        !run.captured.files.empty() || !run.captured.notes.empty())
      lines += short_run_text(run, i + 1);
  }
  return fmt::format(
      "{} runs: {:.1f} s of {} time in {:.1f} s, {}\n{}", session.runs().size(), duration,
      session.runs().front()->result.clock == ClockKind::simulated ? "virtual" : "real", wall_time,
      with_faults == 0 ? "no faults" : fmt::format("{} with faults", with_faults), lines);
}

std::string cell_text(const Literal& value) {
  if (const auto* number = value.as<double>()) return fmt::format("{:.6g}", *number);
  if (const auto* text = value.as<std::string>()) return *text;
  constexpr std::size_t longest = 6;  // of a list that is read in a table
  if (const auto* list = value.as<Literal::List>(); list != nullptr && list->size() > longest)
    return fmt::format("{} values", list->size());
  return value.text();
}

/// What was published under one name: a column for each key, in the order of their appearance.
class PublishedTable {
 public:
  explicit PublishedTable(std::string name) : name_(std::move(name)) {}

  void add(const Literal& row) {
    auto& cells = rows_.emplace_back();
    if (const auto* table = row.as<Literal::Table>())
      for (const auto& [key, value] : *table) cells.emplace(column(key), cell_text(value));
    else if (const auto* list = row.as<Literal::List>())
      for (std::size_t i = 0; i < list->size(); ++i)
        cells.emplace(column(std::to_string(i + 1)), cell_text((*list)[i]));
  }
  std::string text() const {
    std::string text = name_ + "\n" + line([&](std::size_t i) { return columns_[i]; });
    for (const auto& row : rows_)
      text += line([&](std::size_t i) {
        const auto found = row.find(i);
        return found == row.end() ? std::string("-") : found->second;
      });
    return text;
  }

 private:
  std::size_t column(const std::string& key) {
    const auto found = std::find(columns_.begin(), columns_.end(), key);
    if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
    columns_.push_back(key);
    return columns_.size() - 1;
  }
  std::string line(const auto& cell) const {
    std::string text;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      std::size_t width = columns_[i].size();
      for (const auto& row : rows_)
        if (const auto found = row.find(i); found != row.end())
          width = std::max(width, found->second.size());
      text += fmt::format("  {:<{}}", cell(i), width);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  }

  std::string name_;
  std::vector<std::string> columns_;
  std::vector<std::map<std::size_t, std::string>> rows_;
};

std::string published_text(const Session& session) {
  std::vector<std::string> names;
  for (const Published& one : session.published())
    if (std::find(names.begin(), names.end(), one.name) == names.end()) names.push_back(one.name);
  std::string text;
  for (const std::string& name : names) {
    PublishedTable table(name);
    for (const Published& one : session.published())
      if (one.name == name) table.add(one.row);
    text += "\n" + table.text();
  }
  return text;
}

}  // namespace

std::string report_text(const Session& session) {
  std::string text;
  std::int64_t rows = 0;
  std::int64_t lost = 0;
  std::int64_t missed = 0;  // by the recorder
  const bool many = session.runs().size() > most_runs_listed;
  if (many) text += many_runs_text(session);
  for (std::size_t i = 0; i < session.runs().size(); ++i) {
    const SessionRun& run = *session.runs()[i];
    if (!many) text += session.runs().size() > 1 ? short_run_text(run, i + 1) : run_text(run);
    for (const ThreadResult& thread : run.result.threads) {
      rows += thread.loop.rows;
      lost += thread.loop.rows_lost;
    }
    for (const ReaderLoss& loss : run.result.missed)
      if (loss.reader == Recorder::name) missed += static_cast<std::int64_t>(loss.records);
  }
  if (!session.log_path().empty())
    text += fmt::format("recorded {} rows to {}, {} lost\n", rows - missed, session.log_path(),
                        lost + missed);
  text += published_text(session);
  for (const std::string& trouble : session.troubles()) text += "LOG: " + trouble + "\n";
  return text;
}

}  // namespace trocar
