// SPDX-License-Identifier: Apache-2.0
#include "gui/analysis/plot_layout.hpp"

#include <fmt/format.h>

#include <QFile>
#include <QSaveFile>
#include <nlohmann/json.hpp>

#include "framework/text.hpp"

namespace trocar::gui {
namespace {

using Json = nlohmann::ordered_json;

constexpr int layout_version = 1;
constexpr const char* head = "trocar_layout";
constexpr std::array kind_names = {"time", "xy"};

/// A JSON object that is read member by member: what nobody asked for is a mistake of its writer.
class Members {
 public:
  Members(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
    if (!json.is_object()) fail("is " + json.dump() + " and not an object { … }");
  }

  const Json* find(const char* name) {
    known_.emplace_back(name);
    const auto found = json_.find(name);
    return found == json_.end() ? nullptr : &*found;
  }
  double number(const char* name, double otherwise, double low, double high) {
    const Json* json = find(name);
    return json == nullptr ? otherwise : number_of(*json, name, low, high);
  }
  double number_of(const Json& json, const std::string& name, double low, double high) const {
    const double value = json.is_number() ? json.get<double>() : std::nan("");
    if (!(value >= low && value <= high))
      fail(fmt::format("has {} = {}, which is no number from {} to {}", name, json.dump(), low,
                       high));
    return value;
  }
  bool flag(const char* name, bool otherwise) {
    const Json* json = find(name);
    if (json == nullptr) return otherwise;
    if (!json->is_boolean()) fail(fmt::format("has {} = {}: true or false", name, json->dump()));
    return json->get<bool>();
  }
  std::string text(const char* name, const std::string& otherwise) {
    const Json* json = find(name);
    if (json == nullptr) return otherwise;
    if (!json->is_string()) fail(fmt::format("has {} = {}, which is no text", name, json->dump()));
    return json->get<std::string>();
  }
  /// @return the place in `names`
  template <std::size_t n>
  std::size_t one_of(const char* name, const std::array<const char*, n>& names,
                     std::size_t otherwise) {
    const std::string given = text(name, names[otherwise]);
    for (std::size_t i = 0; i < n; ++i)
      if (given == names[i]) return i;
    const std::vector<std::string> all(names.begin(), names.end());
    fail(fmt::format("has {} = \"{}\"{}", name, given, suggestion(given, all)));
  }
  const Json& list(const char* name) {
    const Json* json = find(name);
    if (json == nullptr || !json->is_array()) fail(fmt::format("has no list \"{}\"", name));
    return *json;
  }
  void end() const {
    for (const auto& [key, value] : json_.items())
      if (std::find(known_.begin(), known_.end(), key) == known_.end())
        fail(fmt::format("has \"{}\", which is unknown{}", key, suggestion(key, known_)));
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(where_ + " " + what);
  }

 private:
  const Json& json_;
  std::string where_;
  std::vector<std::string> known_;
};

constexpr double huge = 1e12;

PlotDescription read_plot(const Json& json, const std::string& where) {
  Members members(json, where);
  PlotDescription plot;
  plot.kind = static_cast<PlotDescription::Kind>(members.one_of("kind", kind_names, 0));
  plot.title = members.text("title", "");
  plot.height = members.number("height", 1.0, 0.01, 100.0);
  for (const Json& signal : members.list("signals")) {
    if (!signal.is_string()) members.fail("has the signal " + signal.dump() + ", which is no text");
    plot.names.push_back(signal.get<std::string>());
  }
  if (plot.kind == PlotDescription::Kind::xy && plot.names.size() != 2)
    members.fail(fmt::format("is of kind \"xy\" and has {} signals instead of two, x and y",
                             plot.names.size()));
  members.end();
  return plot;
}

TriggerSettings read_trigger(const Json& json) {
  Members members(json, "the trigger");
  TriggerSettings trigger;
  trigger.signal = members.text("signal", "");
  trigger.when = static_cast<TriggerSettings::When>(members.one_of("when", trigger_whens, 0));
  trigger.mode = static_cast<TriggerSettings::Mode>(
      members.one_of("mode", trigger_modes, static_cast<std::size_t>(trigger.mode)));
  trigger.level = members.number("level", 0.0, -huge, huge);
  trigger.hysteresis = members.number("hysteresis", 0.0, 0.0, huge);
  trigger.before = members.number("before", trigger.before, 0.0, greatest_span);
  trigger.after = members.number("after", trigger.after, least_span, greatest_span);
  members.end();
  return trigger;
}

Json json_of(const PlotDescription& plot) {
  return {{"kind", kind_names[static_cast<std::size_t>(plot.kind)]},
          {"title", plot.title},
          {"signals", plot.names},
          {"height", plot.height}};
}

Json json_of(const TriggerSettings& trigger) {
  return {{"signal", trigger.signal},
          {"when", trigger_whens[static_cast<std::size_t>(trigger.when)]},
          {"mode", trigger_modes[static_cast<std::size_t>(trigger.mode)]},
          {"level", trigger.level},
          {"hysteresis", trigger.hysteresis},
          {"before", trigger.before},
          {"after", trigger.after}};
}

}  // namespace

QByteArray layout_text(const PlotLayout& layout) {
  Json json = {{head, layout_version}, {"span", layout.span}, {"events", layout.events}};
  if (layout.cursors) json["cursors"] = *layout.cursors;
  if (layout.trigger) json["trigger"] = json_of(*layout.trigger);
  json["plots"] = Json::array();
  for (const PlotDescription& plot : layout.plots) json["plots"].push_back(json_of(plot));
  return QByteArray::fromStdString(json.dump(2)) + "\n";
}

PlotLayout read_layout(const QByteArray& text) {
  Json json;
  try {
    json = Json::parse(text.begin(), text.end());
  } catch (const Json::parse_error& error) {
    throw std::invalid_argument("the layout is no JSON: " + std::string(error.what()));
  }
  Members members(json, "the layout");
  const Json* given = members.find(head);
  if (given == nullptr) members.fail(fmt::format("has no \"{}\": {}", head, layout_version));
  if (*given != layout_version)
    members.fail(
        fmt::format("is of version {}, and this program reads {}", given->dump(), layout_version));
  PlotLayout layout;
  layout.span = members.number("span", layout.span, least_span, greatest_span);
  layout.events = members.flag("events", layout.events);
  if (const Json* cursors = members.find("cursors")) {
    if (!cursors->is_array() || cursors->size() != 2)
      members.fail("has cursors = " + cursors->dump() + ": two times [s] are needed");
    layout.cursors = {members.number_of((*cursors)[0], "cursor A", -greatest_span, greatest_span),
                      members.number_of((*cursors)[1], "cursor B", -greatest_span, greatest_span)};
  }
  if (const Json* trigger = members.find("trigger")) layout.trigger = read_trigger(*trigger);
  std::size_t number = 0;
  for (const Json& plot : members.list("plots"))
    layout.plots.push_back(read_plot(plot, fmt::format("plot {}", ++number)));
  members.end();
  return layout;
}

PlotLayout read_layout_file(const QString& path) {
  QFile file(path);
  if (!file.open(QFile::ReadOnly))
    throw std::runtime_error(QString("%1: %2").arg(path, file.errorString()).toStdString());
  try {
    return read_layout(file.readAll());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path.toStdString() + ": " + error.what());
  }
}

void write_layout_file(const QString& path, const PlotLayout& layout) {
  QSaveFile file(path);
  if (!file.open(QFile::WriteOnly) || file.write(layout_text(layout)) < 0 || !file.commit())
    throw std::runtime_error(QString("%1: %2").arg(path, file.errorString()).toStdString());
}

}  // namespace trocar::gui
