// SPDX-License-Identifier: Apache-2.0
#include "gui/data/column.hpp"

#include <algorithm>

namespace trocar::gui {

Column::Column(std::size_t capacity)
    : capacity_(std::max<std::size_t>(2, (capacity + block - 1) / block) * block) {}

std::uint64_t Column::first() const {
  const std::uint64_t being_filled = (end_ + block - 1) / block * block;
  return being_filled <= capacity_ ? 0 : being_filled - capacity_;
}

void Column::add(double value) {
  // Memory grows as samples come: most columns never get so long.
  if (end_ < capacity_)
    values_.push_back(value);
  else
    values_[end_ % capacity_] = value;
  for (std::size_t level = 0; level < steps.size(); ++level) {
    std::vector<Extremes>& list = levels_[level];
    const std::size_t at = (end_ % capacity_) / steps[level];
    if (at == list.size()) list.emplace_back();
    if (end_ % steps[level] == 0) list[at] = {};
    list[at].add(value);
  }
  ++end_;
}

Extremes Column::extremes(std::uint64_t from, std::uint64_t to) const {
  Extremes extremes;
  from = std::max(from, first());
  to = std::min(to, end_);
  while (from < to) {
    std::size_t level = steps.size();
    while (level > 0 && (from % steps[level - 1] != 0 || from + steps[level - 1] > to)) --level;
    if (level == 0) {
      extremes.add(values_[from % capacity_]);
      ++from;
    } else {
      extremes.add(levels_[level - 1][(from % capacity_) / steps[level - 1]]);
      from += steps[level - 1];
    }
  }
  return extremes;
}

}  // namespace trocar::gui
