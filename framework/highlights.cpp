// SPDX-License-Identifier: Apache-2.0
#include "framework/highlights.hpp"

#include <algorithm>
#include <cstring>

namespace trocar {
namespace {

Vector3 vector_at(std::span<const std::byte> row, std::size_t offset) {
  Vector3 value;
  std::memcpy(&value, row.data() + offset, sizeof value);
  return value;
}

}  // namespace

void Highlights::begin(const RowLayout& layout, const WiredGraph& graph) {
  for (const ScheduleItem& item : graph.schedule()) {
    const auto& placement = item.component->placement();
    if (!placement || placement->force == nullptr) continue;
    if (placement->position != nullptr)
      for (const Source& source : placement->position->sources())
        add(layout, *source.output, source.offset, false);
    add(layout, *placement->force, 0, true);
  }
}

void Highlights::add(const RowLayout& layout, const OutputPort& output, std::size_t offset,
                     bool is_force) {
  const std::string port_name = output.owner_name() + "." + output.name();
  for (const RowPort& port : layout.ports()) {
    if (port.name != port_name) continue;
    Highlight one{.name = port_name,
                  .unit = is_force ? "N" : "m",
                  .is_force = is_force,
                  .row_offset = port.row_offset + offset};
    const bool known = std::any_of(all_.begin(), all_.end(), [&](const Highlight& other) {
      return other.row_offset == one.row_offset;
    });
    if (!known) all_.push_back(std::move(one));
  }
}

void Highlights::row(std::span<const std::byte> row) {
  latest_.time = static_cast<double>(header_of(row).time) * 1e-9;
  latest_.values.clear();
  for (Highlight& one : all_) {
    one.last = vector_at(row, one.row_offset);
    latest_.values.push_back(one.last);
    const double size = one.last.eigen().norm();
    if (!(size > one.peak)) continue;  // nor for a NaN
    one.peak = size;
    one.peak_time = latest_.time;
    one.at_peak = one.last;
  }
  if (count_++ % stride_ == 0) moments_.push_back(latest_);
  if (moments_.size() < most_moments) return;
  for (std::size_t i = 0; 2 * i < moments_.size(); ++i) moments_[i] = moments_[2 * i];
  moments_.resize(moments_.size() / 2);
  stride_ *= 2;
}

std::vector<Highlights::Moment> Highlights::moments() const {
  std::vector<Moment> all = moments_;
  if (count_ > 0 && (all.empty() || all.back().time < latest_.time)) all.push_back(latest_);
  return all;
}

}  // namespace trocar
