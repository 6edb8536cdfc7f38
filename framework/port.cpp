// SPDX-License-Identifier: Apache-2.0
#include "framework/port.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "framework/component.hpp"
#include "framework/text.hpp"

namespace trocar {
namespace {

std::vector<Unit> units_of(const TypeInfo& type, std::string_view text) {
  std::vector<Unit> units;
  if (text.empty())
    for (const std::string& usual : type.units) units.push_back(parse_unit(usual));
  else
    for (const std::string_view part : split(text, ',')) units.push_back(parse_unit(part));
  return units;
}

std::optional<Signature> declared(const TypeInfo* type, const PortOptions& options) {
  if (type == nullptr) return std::nullopt;
  Signature signature{type, options.axes, units_of(*type, options.unit),
                      std::string(options.frame)};
  const std::size_t units = signature.units.size();
  if (type->per_axis == 1) signature.axes = static_cast<int>(units);
  const bool fits =
      type->per_axis == 1 ? units >= 1 && units <= max_axes : units == type->units.size();
  if (!fits || (type->per_axis == 6 && (options.axes < 1 || options.axes > max_axes)))
    throw std::logic_error(fmt::format("a port of type {} cannot have the unit \"{}\" and {} axes",
                                       type->name, options.unit, signature.axes));
  return signature;
}

std::string list(const std::vector<Unit>& units) {
  std::vector<std::string> symbols;
  for (const Unit& unit : units) symbols.push_back(unit.symbol.empty() ? "1" : unit.symbol);
  return join(symbols, ", ");
}

}  // namespace

std::string Signature::text() const {
  std::string result = type->name;
  if (type->per_axis > 0) result += fmt::format(" of {} axes", axes);
  result += " [" + list(units) + "]";
  if (!frame.empty()) result += " in " + frame;
  return result;
}

std::string Signature::unit_text() const {
  const bool any = std::any_of(units.begin(), units.end(),
                               [](const Unit& unit) { return !unit.symbol.empty(); });
  return any ? list(units) : "";
}

std::string mismatch(const Signature& source, const Signature& target) {
  if (source.type != target.type)
    return fmt::format("a {} cannot go where a {} is needed", source.type->name, target.type->name);
  if (source.axes != target.axes)
    return fmt::format("{} axes cannot go where {} are needed", source.axes, target.axes);
  for (std::size_t i = 0; i < target.units.size(); ++i)
    if (i >= source.units.size() || source.units[i].dimension != target.units[i].dimension)
      return fmt::format("[{}] cannot go where [{}] is needed", list(source.units),
                         list(target.units));
  if (!source.frame.empty() && !target.frame.empty() && source.frame != target.frame)
    return fmt::format("a value in frame \"{}\" cannot go where frame \"{}\" is needed",
                       source.frame, target.frame);
  return "";
}

FieldSelection select_field(const Signature& whole, std::string_view path) {
  FieldSelection selection{whole, 0};
  if (path.empty()) return selection;
  for (const std::string_view part : split(path, '.')) {
    const TypeInfo& type = *selection.signature.type;
    const std::size_t count = field_count(type, selection.signature.axes);
    std::vector<std::string> names;
    const TypeField* found = nullptr;
    for (std::size_t i = 0; i < count; ++i) {
      names.push_back(type.fields[i].name);
      if (type.fields[i].name == part) found = &type.fields[i];
    }
    if (found == nullptr)
      throw std::invalid_argument(
          names.empty() ? fmt::format("a {} has no fields, \"{}\" was asked for", type.name, part)
                        : fmt::format("a {} has no field \"{}\"{}", type.name, part,
                                      suggestion(part, names)));
    selection.offset += found->offset;
    std::vector<Unit> units = {selection.signature.units[found->block]};
    units.resize(std::max<std::size_t>(1, found->type->units.size()), units.front());
    selection.signature = {found->type, 0, std::move(units), selection.signature.frame};
  }
  return selection;
}

Port::Port(Component* owner, std::string_view name, const TypeInfo* type,
           const PortOptions& options)
    : owner_(owner),
      name_(name),
      doc_(options.doc),
      labels_(options.labels),
      signature_(declared(type, options)),
      generic_(type == nullptr) {}

const std::string& Port::owner_name() const {
  return owner_->name();
}

OutputPort::OutputPort(Component* owner, std::string_view name, const TypeInfo* type,
                       const PortOptions& options)
    : Port(owner, name, type, options) {
  owner->add(this);
}

InputPort::InputPort(Component* owner, std::string_view name, const TypeInfo* type,
                     const PortOptions& options, bool variadic)
    : Port(owner, name, type, options),
      optional_(options.optional),
      feedthrough_(options.feedthrough),
      variadic_(variadic) {
  owner->add(this);
}

void InputPort::connect(const Source& source) {
  sources_.push_back(source);
  attach(source.value != nullptr ? source.value : source.output->data() + source.offset);
}

const SampleInfo& InputPort::sample(std::size_t source) const RT_SAFE {
  static constexpr SampleInfo of_this_thread{.tick = 0};
  if (source >= sources_.size() || sources_[source].info == nullptr) return of_this_thread;
  return *sources_[source].info;
}

double InputPort::delay() const {
  double longest = 0.0;
  for (const Source& source : sources_)
    longest = std::max(longest, source.output->quality.delay + source.transfer);
  return longest;
}

double InputPort::resolution(std::size_t i, std::size_t from) const {
  if (from >= sources_.size()) return 0.0;
  const Source& source = sources_[from];
  const std::size_t at = source.offset / sizeof(double) + i;
  const std::vector<double>& all = source.output->quality.resolution;
  return at < all.size() ? all[at] : 0.0;
}

Eigen::Vector3d sum(const Inputs<Vector3>& vectors) RT_SAFE {
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  for (const Vector3* vector : vectors) total += vector->eigen();
  return total;
}

void GenericOutput::place(std::byte* memory) {
  const std::size_t count = signature()->type->size / sizeof(double);
  values_ = {new (memory) double[count]{}, count};
  data_ = memory;
}

}  // namespace trocar
