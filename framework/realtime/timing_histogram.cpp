// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/timing_histogram.hpp"

#include <algorithm>
#include <cmath>

namespace trocar {

std::int64_t TimingHistogram::upper_edge(std::size_t bin) {
  if (bin < (1u << sub_bits)) return static_cast<std::int64_t>(bin);
  const int shift = static_cast<int>(bin >> sub_bits) - 1;
  const std::uint64_t mantissa = (1u << sub_bits) + (bin & 15u) + 1;
  return static_cast<std::int64_t>((mantissa << shift) - 1);
}

std::int64_t TimingHistogram::percentile(double share) const {
  const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    seen += bins_[i];
    if (seen >= wanted && seen > 0) return std::min(upper_edge(i), max());
  }
  return max();
}

void TimingHistogram::add(const TimingHistogram& other) {
  for (std::size_t i = 0; i < bins_.size(); ++i) bins_[i] += other.bins_[i];
  count_ += other.count_;
  total_ += other.total_;
  max_ = std::max(max_, other.max_);
}

std::vector<TimingHistogram::Bin> TimingHistogram::bins() const {
  std::vector<Bin> filled;
  for (std::size_t i = 0; i < bins_.size(); ++i)
    if (bins_[i] > 0)
      filled.push_back({i == 0 ? 0 : upper_edge(i - 1) + 1, upper_edge(i), bins_[i]});
  return filled;
}

}  // namespace trocar
