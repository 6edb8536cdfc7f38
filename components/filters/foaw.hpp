// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "components/filters/velocity_filter.hpp"

namespace trocar {

/// First-order adaptive windowing: the slope of the longest line, ending now, from which none of
/// its samples is further than the noise band d.
///
///   v_k = slope of the line over x_{k-n} … x_k,  n the largest of 1 … window with
///         |x_{k-j} - line(t_{k-j})| <= d for all j, and likewise for every shorter line
///
/// Fit::end draws the line through the first and the last sample, Fit::best by least squares.
/// Slow motion takes the whole window (late by window T / 2), fast changes a short one. d is one
/// encoder count; d = 0 leaves the backward difference of all that is not straight.
/// (Janabi-Sharifi, Hayward & Chen, IEEE Trans. Control Systems Technology 8(6), 2000.) Sample
/// times need not be even.
class AdaptiveWindow {
 public:
  static constexpr int longest = 15;
  enum class Fit { end, best };
  struct Settings {
    int window = longest;  // 1–15 intervals
    double band = 0.0;     // d, in the unit of the signal
    Fit fit = Fit::best;
  };

  explicit AdaptiveWindow(const Settings& settings) : settings_(settings) {}
  /// At rest there for the whole window.
  void reset(double position, double period) RT_SAFE;
  /// @param dt [s] since the last sample
  /// @return rate [unit/s]
  double update(double position, double dt) RT_SAFE;

 private:
  struct Line {
    double at_newest = 0.0;  // above the newest sample
    double slope = 0.0;
  };
  Line end_fit(int n) const RT_SAFE;
  Line best_fit(int n) const RT_SAFE;
  bool within_band(const Line& line, int n) const RT_SAFE;

  Settings settings_;
  std::array<double, longest + 1> position_{};  // newest first
  std::array<double, longest + 1> age_{};       // [s]
};

/// An AdaptiveWindow for each number of a signal. Its quality is that of the whole window: a count
/// that flips within the band moves the slope by at most d / (window T).
class Foaw final : public VelocityFilter {
 public:
  /// @throw std::invalid_argument for a rotation, or a band that fits no number of the signal.
  void configure(const Setup& setup) override;

  Parameter<std::int64_t> window{
      this,
      "window",
      {.initial = "15", .min = "1", .max = "15", .doc = "longest, in intervals between samples"}};
  Parameter<Choice> fit{this,
                        "fit",
                        {.initial = "best",
                         .doc = "the line through the ends of the window, or by least squares",
                         .choices = {"end", "best"}}};
  Parameter<Quantity> band{
      this,
      "band",
      {.initial = "0", .doc = "noise of those numbers whose resolution the signal does not state"}};

 private:
  double band_of(std::size_t i, const Unit& unit) const;
  void reset(std::size_t i, double now) RT_SAFE override { filters_[i].reset(now, period_); }
  double update(std::size_t i, double now, double dt) RT_SAFE override {
    return filters_[i].update(now, dt);
  }
  std::vector<AdaptiveWindow> filters_;
  double period_ = 1e-3;  // [s]
};

}  // namespace trocar
