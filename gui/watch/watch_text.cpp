// SPDX-License-Identifier: Apache-2.0
#include "gui/watch/watch_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trocar::gui {
namespace {

constexpr std::size_t most_remarks = 5;  // on a screen

bool is_head(const std::string& name) {
  for (const char* head : {"tick", "time", "lateness", "duration", "flags"})
    if (name == head) return true;
  return name.starts_with("step_times.");
}

/// Without patterns, what the components said: of the row's head the headline tells.
bool wanted(const std::string& name, const std::vector<std::string>& patterns) {
  if (patterns.empty()) return !is_head(name);
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return matches(pattern, name); });
}

std::string run_words(const WatchView& view) {
  if (view.link != LinkState::open)
    return "state UNKNOWN, the device may still be engaged: " + view.why;
  if (view.state.run == 0) return "no run yet";
  if (!view.state.running) return fmt::format("run {} has ended", view.state.run);
  bool rendering = false, fault = false;
  double rate = 0.0, late = 0.0, time = view.state.time;
  for (const WatchedThread* thread : view.threads) {
    if (!thread->has_values()) continue;
    rendering = rendering || thread->rendering();
    fault = fault || thread->fault_latched();
    rate = std::max(rate, thread->rate());
    late = std::max(late, thread->worst_lateness());
    time = std::max(time, thread->time());
  }
  return fmt::format("run {}  {:.2f} s  {}{}  {:.0f} Hz  late {:.0f} µs at most", view.state.run,
                     time, rendering ? "RENDERING" : "not rendering",
                     fault ? "  FAULT LATCHED" : "", rate, 1e6 * late);
}

std::string recording_words(const StreamState& state) {
  std::string words;
  if (!state.log.empty()) words += "  log " + state.log;
  if (!state.recording.file.empty())
    words += fmt::format("  REC {} {} rows, {} lost", state.recording.file, state.recording.rows,
                         state.recording.missed);
  if (!state.trouble.empty()) words += "  RECORDING FAILED: " + state.trouble;
  return words;
}

nlohmann::ordered_json finite_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

/// Cut to `width` characters of UTF-8.
std::string cut(const std::string& line, std::size_t width) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < line.size(); ++i)
    if ((static_cast<unsigned char>(line[i]) & 0xc0u) != 0x80u && characters++ == width)
      return line.substr(0, i);
  return line;
}

}  // namespace

std::string headline(const WatchView& view) {
  std::string link = to_string(view.link);
  if (view.link == LinkState::open && view.round_trip_ms >= 0)
    link = fmt::format("link {:.0f} ms", view.round_trip_ms);
  return fmt::format("{}  {}  {}{}", view.url, link, run_words(view), recording_words(view.state));
}

std::vector<std::string> signal_lines(const WatchView& view) {
  std::vector<std::string> lines;
  std::size_t width = 0;
  for (const WatchedThread* thread : view.threads)
    for (const WatchedSignal& signal : thread->signal_list())
      if (wanted(signal.name, view.patterns)) width = std::max(width, signal.name.size());
  for (const WatchedThread* thread : view.threads)
    for (const WatchedSignal& signal : thread->signal_list()) {
      if (!wanted(signal.name, view.patterns)) continue;
      if (thread->has_values())
        lines.push_back(fmt::format("{:<{}}  {:>12.6g} {:<7} {:>12.6g} … {:.6g}", signal.name,
                                    width, signal.last, signal.unit, signal.min, signal.max));
      else
        lines.push_back(fmt::format("{:<{}}  {:>12} {}", signal.name, width, "-", signal.unit));
    }
  return lines;
}

std::string screen_text(const WatchView& view, std::size_t width, std::size_t height) {
  std::vector<std::string> lines = {headline(view), ""};
  const std::size_t remarks = std::min(view.remarks.size(), most_remarks);
  const std::size_t used = lines.size() + remarks + 2;
  const std::size_t room = height > used ? height - used : 1;
  const std::vector<std::string> signals = signal_lines(view);
  for (std::size_t i = 0; i < std::min(room, signals.size()); ++i) lines.push_back(signals[i]);
  lines.push_back(signals.size() > room ? fmt::format("… and {} more: --signals PATTERN chooses",
                                                      signals.size() - room)
                                        : "");
  for (std::size_t i = view.remarks.size() - remarks; i < view.remarks.size(); ++i)
    lines.push_back(view.remarks[i]);
  lines.push_back("space stops the rendering, a acknowledges, q leaves (the run goes on)");
  std::string text;
  for (const std::string& line : lines)
    text += (text.empty() ? "" : "\n") + cut(line, width) + "\033[K";
  return text;
}

std::string event_text(const RunEvent& event) {
  std::string text = fmt::format("{:10.4f} s  tick {}  {}", event.time, event.tick, event.kind);
  if (!event.source.empty()) text += "  " + event.source;
  if (!event.detail.empty()) text += ": " + event.detail;
  if (event.kind == "fault")
    text += fmt::format(" ({:.4g}, limit {:.4g})", event.value, event.limit);
  return text;
}

nlohmann::ordered_json values_json(const WatchedThread& thread,
                                   const std::vector<std::string>& patterns) {
  nlohmann::ordered_json signals = nlohmann::ordered_json::object();
  for (const WatchedSignal& signal : thread.signal_list())
    if (patterns.empty() || wanted(signal.name, patterns))
      signals[signal.name] = {{"last", finite_or_null(signal.last)},
                              {"min", finite_or_null(signal.min)},
                              {"max", finite_or_null(signal.max)},
                              {"unit", signal.unit}};
  return {{"type", "values"},
          {"thread", thread.name()},
          {"tick", thread.tick()},
          {"time", thread.time()},
          {"rendering", thread.rendering()},
          {"fault_latched", thread.fault_latched()},
          {"signals", std::move(signals)}};
}

nlohmann::ordered_json event_json(const RunEvent& event) {
  return {{"type", "event"},
          {"tick", event.tick},
          {"time", event.time},
          {"thread", event.thread},
          {"kind", event.kind},
          {"source", event.source},
          {"detail", event.detail},
          {"value", finite_or_null(event.value)},
          {"limit", finite_or_null(event.limit)}};
}

}  // namespace trocar::gui
