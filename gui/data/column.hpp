// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gui/data/extremes.hpp"

namespace trocar::gui {

/// The newest samples of a signal, with the extremes of each 16, 256 and 4096 of them: those of any
/// range are found in a time that does not grow with it, so that a picture of ten minutes shows
/// what lasted one tick.
/// Samples are numbered from 0; when there is no room the oldest 4096 go.
class Column {
 public:
  static constexpr std::size_t block = 4096;

  /// @param capacity in samples, rounded up to whole blocks, at least two
  explicit Column(std::size_t capacity);

  void add(double value);
  std::uint64_t end() const { return end_; }  // behind the newest
  std::uint64_t first() const;                // the oldest that is there
  std::size_t capacity() const { return capacity_; }

  /// @param n from first() to before end()
  double operator[](std::uint64_t n) const { return values_[n % capacity_]; }
  /// Those from `from` to before `to` as they lie in memory, in at most two pieces; what is not
  /// there any more is left out.
  std::array<std::span<const double>, 2> pieces(std::uint64_t from, std::uint64_t to) const;
  /// Of the samples from `from` to before `to`; what is not there any more does not count.
  Extremes extremes(std::uint64_t from, std::uint64_t to) const;

 private:
  Extremes& block_of(std::size_t level, bool begins);

  static constexpr std::array<std::size_t, 3> shifts = {4, 8, 12};
  static constexpr std::array<std::size_t, 3> steps = {16, 256, 4096};

  std::size_t capacity_;
  std::uint64_t end_ = 0;
  std::size_t place_ = 0;  // of the next in values_
  std::vector<double> values_;
  std::array<std::vector<Extremes>, 3> levels_;
};

}  // namespace trocar::gui
