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

void Highlights::begin(const std::vector<RowLayout>& layouts, const WiredGraph& graph) {
  const Places places = places_in(layouts);
  for (const RateGroup& group : graph.groups())
    for (const ScheduleItem& item : group.schedule()) {
      const auto& placement = item.component->placement();
      if (!placement || placement->force == nullptr) continue;
      if (placement->position != nullptr)
        for (const Source& source : placement->position->sources())
          add(places, *source.output, source.offset, false);
      add(places, *placement->force, 0, true);
    }
  latest_.values.resize(all_.size());
}

Highlights::Places Highlights::places_in(const std::vector<RowLayout>& layouts) {
  Places places;
  for (std::size_t group = 0; group < layouts.size(); ++group)
    for (const RowPort& port : layouts[group].ports())
      places.emplace(port.name, Place{group, port.row_offset});
  return places;
}

void Highlights::add(const Places& places, const OutputPort& output, std::size_t offset,
                     bool is_force) {
  const std::string port_name = output.owner_name() + "." + output.name();
  const auto [begin, end] = places.equal_range(port_name);
  for (auto each = begin; each != end; ++each) {
    const auto [group, row_offset] = each->second;
    if (!known_.emplace(group, row_offset + offset).second) continue;
    all_.push_back({.name = port_name,
                    .unit = is_force ? "N" : "m",
                    .is_force = is_force,
                    .group = group,
                    .row_offset = row_offset + offset});
  }
}

/// A moment is one of the first thread that has anything to show, with what the others had last.
void Highlights::row(std::size_t group, std::span<const std::byte> row) {
  const double time = static_cast<double>(header_of(row).time) * 1e-9;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    Highlight& one = all_[i];
    if (one.group != group) continue;
    latest_.values[i] = one.last = vector_at(row, one.row_offset);
    const double size = one.last.eigen().norm();
    if (!(size > one.peak)) continue;  // nor for a NaN
    one.peak = size;
    one.peak_time = time;
    one.at_peak = one.last;
  }
  if (group != (all_.empty() ? 0 : all_.front().group)) return;
  latest_.time = time;
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
