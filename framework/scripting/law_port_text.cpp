// SPDX-License-Identifier: Apache-2.0
#include "framework/scripting/law_port_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "framework/text.hpp"

namespace trocar::lua {
namespace {

std::vector<std::string> type_names() {
  std::vector<std::string> names;
  for (const TypeInfo* type : port_types()) names.push_back(type->name);
  return names;
}

const TypeInfo* find_type(std::string_view name) {
  for (const TypeInfo* type : port_types())
    if (type->name == name) return type;
  return nullptr;
}

/// Takes `what` off the front, with what is blank around it.
bool take(std::string_view& text, std::string_view what) {
  if (!text.starts_with(what)) return false;
  text = trim(text.substr(what.size()));
  return true;
}

void check_units(LawPort& port, const std::string& written) {
  const std::vector<std::string_view> units = split(port.unit, ',');
  for (const std::string_view unit : units)
    port.si_unit +=
        (port.si_unit.empty() ? "" : ", ") + si_symbol(parse_unit(trim(unit)).dimension);
  const std::size_t needed = port.type->units.size();
  const bool given = !port.unit.empty();
  if (port.type->per_axis == 1) {
    if (!given || units.size() > max_axes)
      throw std::invalid_argument(fmt::format(
          "\"{}\": needs a unit for each axis, e.g. \"Joints [m, m, m, rad, rad, rad]\"", written));
  } else if (given && units.size() != needed) {
    throw std::invalid_argument(fmt::format("\"{}\": a {} has {} unit{}, not {}", written,
                                            port.type->name, needed, needed == 1 ? "" : "s",
                                            units.size()));
  }
}

/// "Vector3 [N] in device", "Joints [m, m, m]", "Jacobian of 6 axes", "N/mm".
void read_text(std::string_view text, LawPort& port) {
  const std::string written(text);
  text = trim(text);
  const std::size_t word = std::min(text.find_first_of(" ["), text.size());
  port.type = find_type(text.substr(0, word));
  if (port.type == nullptr) {
    const std::string first(text.substr(0, word));
    if (text.find('[') != std::string_view::npos)
      throw std::invalid_argument(
          fmt::format("there is no type \"{}\"{}", first, suggestion(first, type_names())));
    port.type = &type_info<double>();
    port.unit = text;
    try {
      port.si_unit = si_symbol(parse_unit(port.unit).dimension);
    } catch (const UnitError& error) {
      const std::string near = nearest(first, type_names());
      throw std::invalid_argument(
          fmt::format("{}{}; a port is a unit, \"m\", or a type, \"Vector3 [N]\"", error.what(),
                      near.empty() ? "" : ", did you mean \"" + near + "\"?"));
    }
    return;
  }
  text = trim(text.substr(word));
  if (take(text, "of")) {
    const auto end = std::from_chars(text.data(), text.data() + text.size(), port.axes).ptr;
    text = trim(text.substr(static_cast<std::size_t>(end - text.data())));
    take(text, "axes");
  }
  if (text.starts_with('[')) {
    const std::size_t close = text.find(']');
    if (close == std::string_view::npos)
      throw std::invalid_argument(fmt::format("\"{}\": a ] is missing", written));
    port.unit = trim(text.substr(1, close - 1));
    if (port.unit == "1") port.unit.clear();
    text = trim(text.substr(close + 1));
  }
  if (take(text, "in ")) port.frame = std::exchange(text, {});
  if (!text.empty())
    throw std::invalid_argument(fmt::format(
        "\"{}\": \"{}\" is not understood, e.g. \"Vector3 [N] in device\"", written, text));
  if (port.type->per_axis == 6 && (port.axes < 1 || port.axes > max_axes))
    throw std::invalid_argument(
        fmt::format("\"{}\": needs axes, e.g. \"Jacobian of 6 axes\"", written));
  check_units(port, written);
}

}  // namespace

LawPort read_law_port(const std::string& name, const Literal& written) {
  LawPort port{.name = name};
  const Literal* text = &written;
  Literal first;
  if (const auto* list = written.as<Literal::List>(); list != nullptr && list->size() == 1)
    text = &list->front();
  if (const auto* table = written.as<Literal::Table>()) {
    static const std::vector<std::string> known = {"doc", "optional", "labels"};
    for (const auto& [key, value] : *table) {
      if (key == "1")
        first = value;
      else if (key == "doc" && value.as<std::string>() != nullptr)
        port.doc = *value.as<std::string>();
      else if (key == "optional" && value.as<bool>() != nullptr)
        port.optional = *value.as<bool>();
      else if (key == "labels" && value.as<Literal::List>() != nullptr)
        for (const Literal& label : *value.as<Literal::List>())
          port.labels.push_back(label.as<std::string>() != nullptr ? *label.as<std::string>()
                                                                   : label.text());
      else
        throw std::invalid_argument(
            fmt::format("{} = {}: a port has a type, doc, optional and "
                        "labels{}",
                        key, value.text(), suggestion(key, known)));
    }
    text = &first;
  }
  if (text->as<std::string>() == nullptr)
    throw std::invalid_argument(
        fmt::format("{}: needs a unit, \"m\", or a type, \"Vector3 [N]\"", written.text()));
  read_text(*text->as<std::string>(), port);
  if (port.type == &type_info<Enumeration>() && port.labels.empty())
    throw std::invalid_argument(
        "an Enumeration needs labels, e.g. { \"Enumeration\", labels = { \"whole\", \"torn\" } }");
  return port;
}

}  // namespace trocar::lua
