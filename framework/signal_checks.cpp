// SPDX-License-Identifier: Apache-2.0
#include "framework/signal_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace trocar {

const std::vector<std::string>& comparison_names() {
  static const std::vector<std::string> names{"<", "<=", "==", ">=", ">"};
  return names;
}

std::optional<Comparison> comparison_named(std::string_view text) {
  const std::vector<std::string>& names = comparison_names();
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) return std::nullopt;
  return static_cast<Comparison>(found - names.begin());
}

bool compare(double value, Comparison comparison, double bound) {
  switch (comparison) {
    case Comparison::less:
      return value < bound;
    case Comparison::less_or_equal:
      return value <= bound;
    case Comparison::equal:
      return value == bound;
    case Comparison::greater_or_equal:
      return value >= bound;
    case Comparison::greater:
      return value > bound;
  }
  return false;
}

SignalVerdict always(std::span<const double> values, Comparison comparison, double bound) {
  SignalVerdict verdict{.holds = true};
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::isfinite(values[row]) && compare(values[row], comparison, bound)) continue;
    if (verdict.holds) verdict.row = row;
    verdict.holds = false;
    ++verdict.count;
  }
  return verdict;
}

SignalVerdict eventually(std::span<const double> values, Comparison comparison, double bound) {
  SignalVerdict verdict{.count = values.size()};
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!std::isfinite(values[row])) continue;
    if (compare(values[row], comparison, bound)) return {.holds = true, .row = row};
    if (std::abs(values[row] - bound) < std::abs(values[verdict.row] - bound) ||
        !std::isfinite(values[verdict.row]))
      verdict.row = row;
  }
  return verdict;
}

SignalVerdict settles(std::span<const double> values, double target, double band) {
  std::size_t row = values.size();
  while (row > 0 && std::abs(values[row - 1] - target) <= band) --row;
  if (row < values.size()) return {.holds = true, .row = row};
  return {.holds = false, .row = values.empty() ? 0 : values.size() - 1, .count = 1};
}

SignalVerdict peaks(std::span<const double> values, double target, double band) {
  SignalVerdict verdict{.holds = true};
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!std::isfinite(values[row])) return {.holds = false, .row = row, .count = 1};
    const bool beyond =
        target < 0.0 ? values[row] < values[verdict.row] : values[row] > values[verdict.row];
    if (beyond) verdict.row = row;
  }
  verdict.holds = !values.empty() && std::abs(values[verdict.row] - target) <= band;
  return verdict;
}

std::vector<LevelCrossing> crossings(std::span<const double> values, double level) {
  std::vector<LevelCrossing> found;
  int side = 0;  // 0: at the level since the beginning
  for (std::size_t row = 0; row < values.size(); ++row) {
    const int now = values[row] > level ? 1 : values[row] < level ? -1 : side;
    if (side != 0 && now != side) found.push_back({row, now > 0});
    side = now;
  }
  return found;
}

std::vector<double> work(const std::vector<std::vector<double>>& force,
                         const std::vector<std::vector<double>>& velocity,
                         std::span<const double> time) {
  const auto same_length = [&](const std::vector<double>& column) {
    return column.size() == time.size();
  };
  if (force.size() != velocity.size() || force.empty() ||
      !std::all_of(force.begin(), force.end(), same_length) ||
      !std::all_of(velocity.begin(), velocity.end(), same_length))
    throw std::invalid_argument(
        fmt::format("work needs force and velocity of one thread with as many axes, not {} and {}",
                    force.size(), velocity.size()));
  const auto power = [&](std::size_t row) {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < force.size(); ++axis)
      sum += force[axis][row] * velocity[axis][row];
    return sum;
  };
  std::vector<double> done(time.size(), 0.0);
  for (std::size_t row = 1; row < time.size(); ++row)
    done[row] = done[row - 1] + 0.5 * (power(row - 1) + power(row)) * (time[row] - time[row - 1]);
  return done;
}

}  // namespace trocar
