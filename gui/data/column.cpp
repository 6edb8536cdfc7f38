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
    values_[place_] = value;
  block_of(0, end_ % steps[0] == 0).add(value);
  ++end_;
  // Only whole blocks are ever looked up, so that each level waits for those of the one below.
  for (std::size_t level = 1; level < steps.size() && end_ % steps[level - 1] == 0; ++level)
    block_of(level, (end_ - steps[level - 1]) % steps[level] == 0)
        .add(levels_[level - 1][place_ >> shifts[level - 1]]);
  if (++place_ == capacity_) place_ = 0;
}

/// That the newest sample is in.
Extremes& Column::block_of(std::size_t level, bool begins) {
  std::vector<Extremes>& list = levels_[level];
  const std::size_t at = place_ >> shifts[level];
  if (at == list.size()) list.emplace_back();
  if (begins) list[at] = {};
  return list[at];
}

std::array<std::span<const double>, 2> Column::pieces(std::uint64_t from, std::uint64_t to) const {
  from = std::max(from, first());
  to = std::min(to, end_);
  if (from >= to) return {};
  const std::size_t begin = from % capacity_, count = to - from;
  const std::size_t until_wrap = std::min(count, values_.size() - begin);
  return {std::span(values_).subspan(begin, until_wrap),
          std::span(values_).first(count - until_wrap)};
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
