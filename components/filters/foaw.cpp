// SPDX-License-Identifier: Apache-2.0
#include "components/filters/foaw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "components/signal.hpp"

namespace trocar {
namespace {

std::size_t at(int sample) {
  return static_cast<std::size_t>(sample);
}

}  // namespace

void AdaptiveWindow::reset(double position, double period) RT_SAFE {
  position_.fill(position);
  for (int j = 0; j <= longest; ++j) age_[at(j)] = j * period;
}

double AdaptiveWindow::update(double position, double dt) RT_SAFE {
  std::copy_backward(position_.begin(), position_.end() - 1, position_.end());
  std::copy_backward(age_.begin(), age_.end() - 1, age_.end());
  position_[0] = position;
  age_[0] = 0.0;
  for (int j = 1; j <= longest; ++j) age_[at(j)] += dt;

  double slope = end_fit(1).slope;
  for (int n = 2; n <= settings_.window; ++n) {
    const Line line = settings_.fit == Fit::end ? end_fit(n) : best_fit(n);
    if (!within_band(line, n)) break;
    slope = line.slope;
  }
  return slope;
}

AdaptiveWindow::Line AdaptiveWindow::end_fit(int n) const RT_SAFE {
  return {0.0, (position_[0] - position_[at(n)]) / age_[at(n)]};
}

/// Positions count from the newest, so that a small motion far from zero keeps its digits.
AdaptiveWindow::Line AdaptiveWindow::best_fit(int n) const RT_SAFE {
  double t = 0, x = 0, tt = 0, tx = 0;
  for (int j = 0; j <= n; ++j) {
    const double time = -age_[at(j)];
    const double rise = position_[at(j)] - position_[0];
    t += time;
    x += rise;
    tt += time * time;
    tx += time * rise;
  }
  const double samples = n + 1.0;
  const double slope = (samples * tx - t * x) / (samples * tt - t * t);
  return {(x - slope * t) / samples, slope};
}

bool AdaptiveWindow::within_band(const Line& line, int n) const RT_SAFE {
  const double band = settings_.band * (1.0 + 1e-9);  // a residual of one count is within it
  for (int j = 0; j <= n; ++j) {
    const double rise = position_[at(j)] - position_[0];
    if (!(std::abs(rise - (line.at_newest - line.slope * age_[at(j)])) <= band)) return false;
  }
  return true;
}

void Foaw::configure(const Setup& setup) {
  period_ = setup.period;
  const std::size_t numbers = count();
  const std::vector<Unit> units = number_units(*position.signature());
  const auto in_band_unit = [&](const Unit& unit) {
    return unit.dimension == band->unit.dimension;
  };
  if (band->value != 0.0 && std::none_of(units.begin(), units.end(), in_band_unit))
    throw std::invalid_argument(
        fmt::format("band = \"{}\": no number of the position, a {}, has "
                    "that unit",
                    band.text(), position.signature()->text()));
  if (!(band->value >= 0.0 && std::isfinite(band->value)))
    throw std::invalid_argument(fmt::format("band = \"{}\": must be at least 0", band.text()));
  filters_.clear();
  for (std::size_t i = 0; i < numbers; ++i)
    filters_.emplace_back(AdaptiveWindow::Settings{
        .window = static_cast<int>(*window),
        .band = band_of(i, units[i]),
        .fit = fit->index == 0 ? AdaptiveWindow::Fit::end : AdaptiveWindow::Fit::best});
  const double span = static_cast<double>(*window) * setup.period;
  state_quality(0.5 * span, span);
}

double Foaw::band_of(std::size_t i, const Unit& unit) const {
  if (position.resolution(i) > 0.0) return position.resolution(i);
  return unit.dimension == band->unit.dimension ? band->value : 0.0;
}

}  // namespace trocar
