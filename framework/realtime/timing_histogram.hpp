// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "framework/realtime/rt_safe.hpp"

namespace trocar {

/// Counts durations in bins that grow with the duration: 16 bins for each factor of two, so that a
/// percentile is known to 6 %, from 1 ns to minutes. Every sample counts; nothing is filtered.
/// Written by one thread, read when it has ended.
class TimingHistogram {
 public:
  void add(std::int64_t nanoseconds) RT_SAFE {
    const std::uint64_t value = nanoseconds < 0 ? 0 : static_cast<std::uint64_t>(nanoseconds);
    ++bins_[bin(value)];
    ++count_;
    total_ += value;
    if (value > max_) max_ = value;
  }
  /// All samples of another one.
  void add(const TimingHistogram& other);

  std::uint64_t count() const { return count_; }
  std::int64_t max() const { return static_cast<std::int64_t>(max_); }
  double mean() const {
    return count_ == 0 ? 0.0 : static_cast<double>(total_) / static_cast<double>(count_);
  }

  /// [ns] that the share (0 to 1) of all samples does not exceed: the upper edge of its bin.
  std::int64_t percentile(double share) const;

  /// Samples from `lower` to `upper` [ns], both included.
  struct Bin {
    std::int64_t lower = 0;
    std::int64_t upper = 0;
    std::uint64_t count = 0;
  };
  /// Those that are not empty, in order.
  std::vector<Bin> bins() const;

 private:
  static constexpr int sub_bits = 4;
  static constexpr std::size_t bin(std::uint64_t value) RT_SAFE {
    if (value < (1u << sub_bits)) return value;
    const int shift = static_cast<int>(std::bit_width(value)) - 1 - sub_bits;
    return (static_cast<std::size_t>(shift + 1) << sub_bits) + ((value >> shift) & 15u);
  }
  static std::int64_t upper_edge(std::size_t bin);

  std::array<std::uint64_t, 64 << sub_bits> bins_{};
  std::uint64_t count_ = 0;
  std::uint64_t total_ = 0;
  std::uint64_t max_ = 0;
};

}  // namespace trocar
