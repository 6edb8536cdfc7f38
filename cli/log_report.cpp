// SPDX-License-Identifier: Apache-2.0
#include "cli/log_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/output.hpp"
#include "cli/text_table.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

using Json = nlohmann::ordered_json;
using Channel = LogSummary::Channel;

constexpr std::size_t shown = 20;  // lines of a long list

/// Text of unknown origin for a terminal: no control characters.
std::string plain(const std::string& text) {
  std::string result = text;
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return result;
}

std::string rate_text(double hertz) {
  if (!(hertz > 0.0)) return "";
  return hertz >= 999.95 ? fmt::format("{:.4g} kHz", hertz / 1000.0)
                         : fmt::format("{:.4g} Hz", hertz);
}

std::string more_text(std::size_t total) {
  return total <= shown ? "" : fmt::format("  … and {} more (--json has all)\n", total - shown);
}

std::string ticks_text(const TickGaps& ticks) {
  std::string text = "no row lost";
  if (ticks.gaps() > 0)
    text = fmt::format("{} lost in {}, the first behind tick {}", counted(ticks.rows_lost(), "row"),
                       counted(ticks.gaps(), "gap"), *ticks.first_gap());
  if (ticks.slots_skipped() > 0)
    text += fmt::format(", {} skipped by the loop", counted(ticks.slots_skipped(), "slot"));
  if (ticks.runs() > 1) text += fmt::format(", {}", counted(ticks.runs(), "run"));
  return text;
}

std::string channels_text(const LogSummary& log) {
  if (log.channels.empty()) return "";
  TextTable table("lrrl");
  for (const Channel& channel : log.channels) {
    std::string facts = channel.schema.empty() ? "no schema" : channel.schema;
    if (channel.rows && channel.messages > 0) facts += ": " + ticks_text(channel.ticks);
    facts = plain(facts);
    if (!channel.problem.empty()) facts += '\n' + plain(channel.problem);
    table.row({plain(channel.topic), counted(channel.messages, channel.rows ? "row" : "message"),
               rate_text(channel.rate()), facts});
  }
  return "\nChannels\n" + table.text();
}

std::string events_text(const LogSummary& log) {
  if (log.events.empty()) return "";
  const bool several = std::any_of(log.events.begin(), log.events.end(), [&](const auto& event) {
    return event.thread != log.events.front().thread;
  });
  TextTable table(several ? "rrll" : "rrl");
  for (std::size_t i = 0; i < std::min(shown, log.events.size()); ++i) {
    const LogSummary::Event& event = log.events[i];
    std::string what = event.source;
    if (!event.detail.empty()) what += (what.empty() ? "" : ": ") + event.detail;
    if (event.value != 0.0) what += fmt::format(", value {:.6g}", event.value);
    if (event.limit != 0.0) what += fmt::format(" (limit {:.6g})", event.limit);
    std::vector<std::string> cells = {
        fmt::format("{:.3f} s", 1e-9 * static_cast<double>(event.time_ns)),
        fmt::format("tick {}", event.tick), plain(event.kind), plain(what)};
    if (several) cells.insert(cells.begin() + 2, plain(event.thread));
    table.row(std::move(cells));
  }
  return "\nEvents\n" + table.text() + more_text(log.events.size());
}

/// "axis = x, slope = 4.85": what a script gave to publish().
std::string row_text(const Json& row) {
  const auto value_text = [](const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
    constexpr std::size_t longest = 6;  // of a list that is read in a line
    if (value.is_array() && value.size() > longest) return fmt::format("[{} values]", value.size());
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  if (!row.is_object()) return value_text(row);
  std::vector<std::string> parts;
  for (const auto& [key, value] : row.items()) parts.push_back(key + " = " + value_text(value));
  return join(parts, ", ");
}

std::string published_text(const LogSummary& log) {
  std::string text;
  for (const auto& [name, rows] : log.published) {
    text += fmt::format("\nPublished: {} ({})\n", plain(name), counted(rows.size(), "row"));
    for (std::size_t i = 0; i < std::min(shown, rows.size()); ++i)
      text += wrapped(plain(row_text(rows[i])), 2);
    text += more_text(rows.size());
  }
  return text;
}

std::string attachments_text(const LogSummary& log) {
  if (log.attachments.empty()) return "";
  TextTable table("lrl");
  for (const LogSummary::Attachment& attachment : log.attachments)
    table.row({plain(attachment.name), byte_text(attachment.size), plain(attachment.media_type)});
  return "\nAttachments\n" + table.text();
}

/// What each row of a log has besides its signals.
bool belongs_to_row_head(const LogSignal& signal) {
  for (const char* name : {"tick", "time", "lateness", "duration", "flags"})
    if (signal.name == name) return true;
  return signal.name.starts_with("step_times.");
}

/// "[N]" or "[m, rad]": the units of signals that follow each other, each once in a row.
std::string unit_text(const std::vector<LogSignal>& signals, std::size_t begin, std::size_t end) {
  std::vector<std::string> units;
  for (std::size_t i = begin; i < end; ++i)
    if (!signals[i].unit.empty() && (units.empty() || units.back() != signals[i].unit))
      units.push_back(signals[i].unit);
  return join(units, ", ");
}

/// The signals by name, those of one port together.
std::string names_text(const Channel& channel) {
  TextTable table;
  const std::vector<LogSignal>& signals = channel.signal_list;
  for (std::size_t begin = 0, end = 0; begin < signals.size(); begin = end) {
    while (end < signals.size() && signals[end].port == signals[begin].port) ++end;
    if (channel.rows && belongs_to_row_head(signals[begin])) continue;
    const std::string unit = unit_text(signals, begin, end);
    const std::string count = end - begin == 1 ? "" : fmt::format("{} numbers", end - begin);
    table.row({plain(signals[begin].port), count, signals[begin].is_text ? "text" : plain(unit)});
  }
  if (table.empty()) return "";
  return fmt::format("\nSignals of {} (--signals prints their values)\n", plain(channel.topic)) +
         table.text();
}

std::string parent_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(0, dot);
}

std::string values_text(const Channel& channel, const std::string& pattern) {
  constexpr const char* line = "  {:<21} {:<8}{:>12}{:>12}{:>12}{:>12}\n";
  std::string text, parent;
  for (const LogSignal& signal : channel.signal_list) {
    if (signal.count == 0 || signal.is_text || !matches(pattern, signal.name)) continue;
    if (text.empty())
      text = "\nSignals of " + plain(channel.topic) + '\n' +
             fmt::format(line, "", "unit", "first", "last", "min", "max");
    const std::string above = parent_of(signal.name);
    if (above != parent) text += "  " + plain(above) + '\n';
    parent = above;
    const auto number = [](double value) { return fmt::format("{:.5g}", value); };
    const std::string own = above.empty() ? signal.name : signal.name.substr(above.size() + 1);
    text += fmt::format(line, (above.empty() ? "" : "  ") + plain(own), plain(signal.unit),
                        number(signal.first), number(signal.last), number(signal.min),
                        number(signal.max));
  }
  return text;
}

Json channel_json(const Channel& channel, const std::optional<std::string>& pattern) {
  Json json = {{"topic", channel.topic},       {"schema", channel.schema},
               {"encoding", channel.encoding}, {"messages", channel.messages},
               {"rate_hz", channel.rate()},    {"rows", channel.rows},
               {"problem", channel.problem}};
  if (channel.rows) {
    json["rows_lost"] = channel.ticks.rows_lost();
    json["gaps"] = channel.ticks.gaps();
    json["slots_skipped"] = channel.ticks.slots_skipped();
    json["runs"] = channel.ticks.runs();
  }
  json["signals"] = Json::array();
  for (const LogSignal& signal : channel.signal_list) {
    if (pattern && !matches(*pattern, signal.name)) continue;
    Json one = {{"name", signal.name}, {"unit", signal.unit}};
    if (pattern && !signal.is_text) {
      one["first"] = signal.first;
      one["last"] = signal.last;
      one["min"] = signal.min;
      one["max"] = signal.max;
    }
    json["signals"].push_back(std::move(one));
  }
  return json;
}

double size_ratio(const LogSummary& log) {
  return log.payload == 0 ? 0.0
                          : static_cast<double>(log.file_size) / static_cast<double>(log.payload);
}

}  // namespace

std::string log_text(const LogSummary& log, const std::optional<std::string>& pattern) {
  TextTable head;
  head.row({"Written by", log.library.empty() ? "unknown" : plain(log.library)});
  head.row({"Complete", log.complete() ? "yes" : "no: " + plain(log.problem)});
  head.row({"Duration", fmt::format("{:.6g} s", log.duration())});
  head.row({"Size", byte_text(log.file_size) +
                        (log.payload == 0 ? ""
                                          : fmt::format(", {:.3g} times the messages' own bytes",
                                                        size_ratio(log)))});
  std::string text = plain(log.file) + '\n' + head.text() + channels_text(log) + events_text(log) +
                     published_text(log) + attachments_text(log);
  for (const Channel& channel : log.channels)
    text += pattern ? values_text(channel, *pattern) : channel.rows ? names_text(channel) : "";
  return text;
}

Json log_json(const LogSummary& log, const std::optional<std::string>& pattern) {
  Json json = {{"file", log.file},
               {"library", log.library},
               {"complete", log.complete()},
               {"problem", log.problem},
               {"duration_s", log.duration()},
               {"bytes", log.file_size},
               {"payload_bytes", log.payload},
               {"size_ratio", size_ratio(log)}};
  for (const char* list : {"channels", "events", "attachments"}) json[list] = Json::array();
  for (const Channel& channel : log.channels)
    json["channels"].push_back(channel_json(channel, pattern));
  for (const LogSummary::Event& event : log.events)
    json["events"].push_back({{"tick", event.tick},
                              {"time_ns", event.time_ns},
                              {"thread", event.thread},
                              {"kind", event.kind},
                              {"source", event.source},
                              {"detail", event.detail},
                              {"value", event.value},
                              {"limit", event.limit}});
  json["published"] = Json::object();
  for (const auto& [name, rows] : log.published) json["published"][name] = rows;
  for (const LogSummary::Attachment& attachment : log.attachments)
    json["attachments"].push_back({{"name", attachment.name},
                                   {"media_type", attachment.media_type},
                                   {"bytes", attachment.size}});
  return json;
}

}  // namespace trocar::cli
