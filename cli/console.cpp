// SPDX-License-Identifier: Apache-2.0
#include "cli/console.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "cli/text_table.hpp"
#include "framework/text.hpp"

namespace trocar::cli {
namespace {

constexpr std::string_view help_text =
    "wall.force                newest values; also of a whole component\n"
    "wall.stiffness            a parameter\n"
    "wall.stiffness = 3 N/mm   its new value, reached by a ramp\n"
    "list [text]               signals and parameters whose name contains the text\n"
    "stop                      stop the rendering\n"
    "acknowledge               acknowledge a fault\n"
    "home                      let a device find its references\n"
    "engage                    render again\n"
    "note the gel is dry       a remark for the log\n"
    "end                       end the run\n"
    "Tab completes, arrow keys go back to earlier lines.\n";

/// To six digits: what people read, not what programs compute with.
std::string value_text(double value, const RowSignal& signal) {
  if (signal.scalar == Scalar::boolean) return value != 0.0 ? "true" : "false";
  const double rounded = std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
  return format_quantity(rounded, signal.unit);
}

bool is_part_of(const std::string& signal, const std::string& name) {
  return signal == name || (signal.starts_with(name) && signal[name.size()] == '.');
}

std::vector<std::string> commands() {
  std::vector<std::string> names = request_names();
  names.insert(names.end(), {"list", "help", "note"});
  return names;
}

/// The text of a finding, without the place that a line of a console has not.
std::string mistakes(const BrokenGraph& broken) {
  std::string text;
  for (const Finding& finding : broken.findings.all()) text += finding.message + "\n";
  return text;
}

}  // namespace

std::string Console::answer(std::string_view line, RunControl& control) const {
  line = trim(line);
  if (line.empty()) return "";
  if (const std::size_t equals = line.find('='); equals != std::string_view::npos)
    return answer_set(trim(line.substr(0, equals)), trim(line.substr(equals + 1)), control);
  if (line == "help") return std::string(help_text);
  if (line == "list" || line.starts_with("list "))
    return answer_list(trim(line.substr(4)), control);
  if (line.starts_with("note ")) {
    control.annotate(std::string(trim(line.substr(5))));
    return "noted\n";
  }
  if (const auto kind = request_named(line)) {
    control.request(*kind);
    return fmt::format("asked: {}\n", line);
  }
  return answer_name(std::string(line), control);
}

std::string Console::answer_set(std::string_view key, std::string_view value,
                                RunControl& control) const {
  try {
    const std::string name(key);
    const std::string before = control.text(name);
    control.set(name, literal_from_text(value));
    return fmt::format("{}: {} -> {}\n", name, before, control.text(name));
  } catch (const BrokenGraph& broken) {
    return mistakes(broken);
  }
}

std::string Console::answer_list(std::string_view part, RunControl& control) const {
  TextTable table;
  for (const RowSignal& signal : rows_.signals())
    if (signal.name.find(part) != std::string::npos) {
      const auto value = rows_.value(signal);
      table.row({signal.name, value ? value_text(value->number, signal) : "nothing yet"});
    }
  for (const std::string& key : control.live_keys())
    if (key.find(part) != std::string::npos) table.row({key, control.text(key) + ", a parameter"});
  const std::string text = table.text();
  return text.empty() ? fmt::format("no signal's or parameter's name contains \"{}\"\n", part)
                      : text;
}

std::string Console::signals_text(const std::string& name) const {
  TextTable table;
  for (const RowSignal& signal : rows_.signals()) {
    if (!is_part_of(signal.name, name)) continue;
    const auto value = rows_.value(signal);
    table.row({signal.name, value ? value_text(value->number, signal) : "nothing yet",
               value ? fmt::format("at {:.3f} s", value->time) : ""});
  }
  return table.text();
}

std::string Console::answer_name(const std::string& name, RunControl& control) const {
  if (std::string signals = signals_text(name); !signals.empty()) return signals;
  try {
    return fmt::format("{} = {}\n", name, control.text(name));
  } catch (const BrokenGraph&) {
    std::vector<std::string> known = commands();
    for (const RowSignal& signal : rows_.signals()) known.push_back(signal.name);
    for (std::string& key : control.live_keys()) known.push_back(std::move(key));
    const std::string near = nearest(name, known);
    return near.empty()
               ? fmt::format("nothing is called \"{}\"; help says what there is\n", name)
               : fmt::format("nothing is called \"{}\", did you mean \"{}\"?\n", name, near);
  }
}

std::vector<std::string> Console::completions(std::string_view begin, RunControl& control) const {
  std::vector<std::string> found;
  const auto take = [&](const std::string& name) {
    if (name.starts_with(begin)) found.push_back(name);
  };
  for (const std::string& name : commands()) take(name);
  for (const RowSignal& signal : rows_.signals()) {
    take(signal.name);
    // The ports and components that the signal belongs to.
    for (std::size_t dot = signal.name.find('.'); dot != std::string::npos;
         dot = signal.name.find('.', dot + 1))
      take(signal.name.substr(0, dot));
  }
  for (const std::string& key : control.live_keys()) take(key);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace trocar::cli
