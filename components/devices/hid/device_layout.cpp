// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/device_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "components/devices/hid/layout_table.hpp"
#include "framework/text.hpp"
#include "framework/units.hpp"

namespace trocar::hid {
namespace {

constexpr int usual_bytes = 64;  // the most that a full-speed interrupt endpoint sends at once

const std::vector<std::string> layout_entries = {"vendor", "product", "bytes", "fields"};
const std::vector<std::string> part_entries = {"report", "offset", "bits", "signed",
                                               "centre", "scale",  "rest"};
const std::vector<std::string> axis_names = {"x", "y", "z"};
const std::vector<std::string> held_names = {"never", "attached", "always"};

std::vector<std::string> field_entries() {
  std::vector<std::string> all = part_entries;
  for (const char* entry : {"unit", "frame", "held", "doc", "x", "y", "z"}) all.emplace_back(entry);
  return all;
}

/// What the three parts of a vector may have in common.
struct Part {
  int report = 0;
  std::optional<int> offset{}, bits{};
  bool is_signed = false;
  double centre = 0.0, scale = 1.0;
  std::optional<double> rest{};  // as the device counts

  void read(const LayoutTable& table) {
    report = table.whole("report").value_or(report);
    if (const auto given = table.whole("offset")) offset = given;
    if (const auto given = table.whole("bits")) bits = given;
    is_signed = table.flag("signed").value_or(is_signed);
    centre = table.number("centre").value_or(centre);
    scale = table.number("scale").value_or(scale);
    if (const auto given = table.number("rest")) rest = given;
  }
};

class LayoutReader {
 public:
  explicit LayoutReader(std::vector<DefinitionMistake>& mistakes) : mistakes_(mistakes) {}

  std::optional<DeviceLayout> read(const Literal& value) {
    const std::size_t before = mistakes_.size();
    const LayoutTable table(value, {}, mistakes_);
    if (mistakes_.size() > before) return std::nullopt;
    table.refuse_others(layout_entries);
    read_device(table);
    if (const auto bytes = table.whole("bytes")) {
      bytes_ = std::clamp(*bytes, 1, largest_report);
      if (bytes_ != *bytes)
        table.mistake("bytes", fmt::format("{}: a report has 1 to {}", *bytes, largest_report));
    }
    const LayoutTable fields = table.table("fields");
    for (const std::string& name : fields.names()) read_field(fields.table(name), name, fields);
    if (fields.names().empty() && mistakes_.size() == before)
      table.mistake(
          "fields",
          "none: needs some, e.g. fields = { left = { report = 3, offset = 8, bits = 1 } }");
    if (numbers_.size() > most_numbers)
      table.mistake("fields", fmt::format("{} numbers: there may be {}, and 3 are a vector's",
                                          numbers_.size(), most_numbers));
    if (mistakes_.size() > before) return std::nullopt;
    layout_.fields = InputLayout(std::move(numbers_), bytes_);
    return std::move(layout_);
  }

 private:
  std::optional<std::uint16_t> usb(const LayoutTable& table, const char* name,
                                   const std::string& text) {
    try {
      return usb_number(text, name);
    } catch (const std::invalid_argument& error) {
      table.mistake(name, std::string(error.what()).substr(std::string(name).size() + 3));
    }
    return std::nullopt;
  }

  void read_device(const LayoutTable& table) {
    const auto vendor = table.text("vendor");
    const std::vector<std::string> products = table.texts("product");
    if (!table.has("vendor")) table.mistake("vendor", "is missing, e.g. vendor = \"046d\"");
    if (!table.has("product")) table.mistake("product", "is missing, e.g. product = \"c626\"");
    if (vendor) layout_.device.vendor = usb(table, "vendor", *vendor);
    for (const std::string& each : products) {
      const auto product = usb(table, "product", each);
      if (product && !layout_.device.product)
        layout_.device.product = product;
      else if (product)
        layout_.device.or_products.push_back(*product);
    }
  }

  void read_field(const LayoutTable& field, const std::string& name, const LayoutTable& fields) {
    if (!is_name(name) || name != snake_case(name))
      return fields.mistake(name, "is no name of an output: take small letters, digits and _");
    field.refuse_others(field_entries());
    LayoutOutput output{.name = name, .first = numbers_.size()};
    output.unit = field.text("unit").value_or("");
    output.frame = field.text("frame").value_or("");
    output.doc = field.text("doc").value_or("of the device");
    output.held = held(field);
    const double si = unit_scale(field, output.unit);
    Part whole;
    whole.read(field);
    if (std::any_of(axis_names.begin(), axis_names.end(),
                    [&](const std::string& axis) { return field.has(axis); })) {
      output.kind = LayoutOutput::Kind::vector;
      for (std::size_t i = 0; i < 3; ++i) {
        if (!field.has(axis_names[i]))
          field.mistake(axis_names[i], "is missing: a vector has x, y and z");
        const LayoutTable axis = field.table(axis_names[i]);
        axis.refuse_others(part_entries);
        Part part = whole;
        part.read(axis);
        add(part, axis, name + "." + axis_names[i], si, output.rest[i]);
      }
    } else {
      const bool plain = !field.has("unit") && !field.has("scale") && !field.has("centre");
      if (whole.bits == 1 && plain) output.kind = LayoutOutput::Kind::flag;
      if (field.has("frame")) field.mistake("frame", "is for vectors, which have x, y and z");
      add(whole, field, name, si, output.rest[0]);
    }
    layout_.outputs.push_back(std::move(output));
  }

  Held held(const LayoutTable& field) {
    const auto text = field.text("held");
    if (!text) return Held::never;
    const auto found = std::find(held_names.begin(), held_names.end(), *text);
    if (found != held_names.end()) return static_cast<Held>(found - held_names.begin());
    field.mistake(
        "held",
        fmt::format("\"{}\" is none of {}{}", *text, join(held_names, ", "),
                    nearest(*text, held_names).empty() ? "" : suggestion(*text, held_names)));
    return Held::never;
  }

  double unit_scale(const LayoutTable& field, const std::string& unit) {
    try {
      return parse_unit(unit).scale;
    } catch (const UnitError& error) {
      field.mistake("unit", error.what());
      return 1.0;
    }
  }

  void add(const Part& part, const LayoutTable& table, const std::string& name, double si,
           double& rest) {
    if (!part.offset && !table.has("offset"))
      table.mistake("needs offset, the bit where it begins");
    if (!part.bits && !table.has("bits")) table.mistake("needs bits, how many it has");
    if (!part.offset || !part.bits) return;
    if (!std::isfinite(part.rest.value_or(0.0)))
      return table.mistake("rest", fmt::format("{}: must be finite", *part.rest));
    InputField number{.name = name,
                      .report = part.report,
                      .offset = *part.offset,
                      .bits = *part.bits,
                      .is_signed = part.is_signed,
                      .centre = part.centre,
                      .scale = part.scale * si};
    rest = number.scale * (part.rest.value_or(part.centre) - part.centre);
    std::string wrong = trouble_with(number, bytes_);
    for (const InputField& before : numbers_)
      if (wrong.empty()) wrong = trouble_between(before, number);
    if (!wrong.empty()) return table.mistake(wrong);
    numbers_.push_back(std::move(number));
  }

  std::vector<DefinitionMistake>& mistakes_;
  DeviceLayout layout_;
  std::vector<InputField> numbers_;
  int bytes_ = usual_bytes;
};

}  // namespace

std::optional<DeviceLayout> read_device_layout(const Literal& value,
                                               std::vector<DefinitionMistake>& mistakes) {
  return LayoutReader(mistakes).read(value);
}

}  // namespace trocar::hid
