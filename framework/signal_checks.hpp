// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Questions that a test asks of a signal, a number for each row. A number that is not finite is
/// never as it should be.

namespace trocar {

enum class Comparison { less, less_or_equal, equal, greater_or_equal, greater };

/// "<", "<=", "==", ">=", ">"; nothing for another text.
std::optional<Comparison> comparison_named(std::string_view text);
const std::vector<std::string>& comparison_names();
bool compare(double value, Comparison comparison, double bound);

/// What was found, and in which row to look.
struct SignalVerdict {
  bool holds = false;
  std::size_t row = 0;
  std::size_t count = 0;  // rows that speak against it
};

/// Every value compares so. `row` is the first that does not.
SignalVerdict always(std::span<const double> values, Comparison comparison, double bound);
/// Some value compares so. `row` is the first that does, else the one that comes nearest.
SignalVerdict eventually(std::span<const double> values, Comparison comparison, double bound);
/// From some row on, all values are within `band` of `target`. `row` is that row; where the last
/// value is outside of the band, it is the last one.
SignalVerdict settles(std::span<const double> values, double target, double band);
/// The highest value is within `band` of `target`; the lowest one, for a negative target. `row` is
/// the peak's.
SignalVerdict peaks(std::span<const double> values, double target, double band);

/// A step from one side of a level to the other; a value at the level belongs to the side before.
struct LevelCrossing {
  std::size_t row = 0;  // the first on the new side
  bool up = false;
};
std::vector<LevelCrossing> crossings(std::span<const double> values, double level);

/// What has been done along the motion up to each row [J]: E(t) = ∫ Σ F_i v_i dt by the trapezoidal
/// rule. Positive where the force drives the motion: what a fixture has given to the hand.
/// @param force, velocity a column for each axis [N, m/s]
/// @param time [s]
/// @throw std::invalid_argument where they are not of one shape
std::vector<double> work(const std::vector<std::vector<double>>& force,
                         const std::vector<std::vector<double>>& velocity,
                         std::span<const double> time);

}  // namespace trocar
