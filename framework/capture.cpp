// SPDX-License-Identifier: Apache-2.0
#include "framework/capture.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace trocar {
namespace {

std::string field_at(const RowLayout& layout, std::size_t row_offset) {
  for (const RowSignal& signal : layout.signals())
    if (signal.row_offset == row_offset) return signal.name;
  return "the signal";
}

/// In the unit in which a script gave the limit.
std::string text_of(double value, const Unit& unit) {
  return fmt::format("{:.6g}{}{}", value / unit.scale, unit.symbol.empty() ? "" : " ", unit.symbol);
}

}  // namespace

void Capture::configure(const Setup&) {
  const Signature& signature = *signal.signature();
  if (signature.type != &type_info<double>())
    throw std::invalid_argument(fmt::format(
        "signal is a {}: name a single number of it, e.g. wall.force.z", signature.type->name));
  if (!std::isfinite(above->value) && !std::isfinite(below->value))
    throw std::invalid_argument(R"(needs above = "2 N", or below, or both)");
  const Dimension& dimension = signature.units.front().dimension;
  for (const auto* limit : {&above, &below}) {
    const Quantity& given = **limit;
    const bool zero = given.value == 0.0 && given.unit.dimension.dimensionless();
    if (!std::isfinite(given.value) || zero || given.unit.dimension == dimension) continue;
    const std::string needed = si_symbol(dimension);
    throw std::invalid_argument(needed.empty()
                                    ? fmt::format("{} = \"{}\": needs a number without a unit",
                                                  limit->name(), limit->text())
                                    : fmt::format("{} = \"{}\": needs {}, as the signal",
                                                  limit->name(), limit->text(), needed));
  }
}

Trigger::Window SignalTrigger::begin(const std::vector<RowLayout>& layouts,
                                     const WiredGraph& graph) {
  const auto& capture = dynamic_cast<const Capture&>(*graph.find(name_));
  const Source& source = capture.signal.sources().front();
  const std::string port_name = source.output->owner_name() + "." + source.output->name();
  for (std::size_t group = 0; group < layouts.size(); ++group)
    for (const RowPort& port : layouts[group].ports()) {
      if (port.name != port_name) continue;
      group_ = group;
      row_offset_ = port.row_offset + source.offset;
    }
  signal_ = field_at(layouts[group_], row_offset_);
  const Unit unit{si_symbol(capture.signal.signature()->units.front().dimension), {}, 1.0};
  above_ = *capture.above;
  below_ = *capture.below;
  for (Quantity* limit : {&above_, &below_})
    if (limit->unit.symbol.empty()) limit->unit = unit;  // a bare 0
  by_level_ = capture.by_level();
  return {*capture.before, *capture.after};
}

bool SignalTrigger::row(std::size_t group, std::span<const std::byte> row) {
  if (group != group_) return false;
  value_ = number_at(row, row_offset_);
  const bool beyond = value_ > above_.value || value_ < below_.value;
  const bool triggers = beyond && (by_level_ || !was_beyond_);
  was_beyond_ = beyond;
  if (triggers) header_ = header_of(row);
  return triggers;
}

std::string SignalTrigger::cause() const {
  const bool over = value_ > above_.value;
  const Quantity& limit = over ? above_ : below_;
  return fmt::format("{} {} {} at tick {} ({:.3f} s): {}", signal_, over ? "above" : "below",
                     text_of(limit.value, limit.unit), header_.tick,
                     static_cast<double>(header_.time) * 1e-9, text_of(value_, limit.unit));
}

}  // namespace trocar
