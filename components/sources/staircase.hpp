// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/component.hpp"

namespace trocar {

/// A load that goes 0 → +P → 0 → -P → 0 in equal steps, each held for the same time. With n levels
/// from -P to P (n odd, so that 0 is one) and h = (n - 1) / 2, dwell i of 2 n - 1 is at
///
///   level(i) = i          for i = 0 … h          up
///              2 h - i    for i = h … 3 h        down
///              i - 4 h    for i = 3 h … 4 h      up to 0       load = level P / h  [N]
///
/// so that each level but the peaks is met rising and falling, as hysteresis needs. The first part
/// of each dwell moves there from the level before along a raised cosine; the first starts at 0.
/// Before and after the course the load is 0.
struct LoadCourse {
  double peak = 10.0;      // P [N]
  int levels = 9;          // n, odd, at least 3
  double duration = 60.0;  // [s] of all dwells
  double ramp = 0.2;       // share of a dwell that the move takes, 0–0.75

  struct Point {
    double load = 0.0;     // [N]
    bool settled = false;  // in the last quarter of a dwell
  };
  int dwells() const RT_SAFE { return 2 * levels - 1; }
  int level(int dwell) const RT_SAFE;
  Point at(double t) const RT_SAFE;  // t [s] since the course began
};

/// A LoadCourse along one axis of the device's base frame. It hangs on the tool from outside, as
/// weights do, and never goes through the motors.
class Staircase final : public Component {
 public:
  Staircase();
  /// @throw std::invalid_argument for an even number of levels.
  void configure(const Setup& setup) override;
  void step(const Tick& tick) RT_SAFE override;

  Output<Vector3> force{this, "force", {.unit = "N", .frame = "device", .doc = "on the tool"}};
  Output<double> load{this, "load", {.unit = "N", .doc = "signed, along the axis"}};
  Output<bool> settled{
      this, "settled", {.doc = "in the last quarter of a dwell, where a fit may look"}};

  Parameter<double> peak{
      this, "peak", {.unit = "N", .min = "0 N", .max = "100 N", .doc = "largest load, both ways"}};
  Parameter<std::int64_t> levels{
      this,
      "levels",
      {.initial = "9", .min = "2", .max = "1001", .doc = "from -peak to +peak, both counted; odd"}};
  Parameter<Choice> axis{this,
                         "axis",
                         {.initial = "x",
                          .doc = "of the device's base frame, along which it loads",
                          .choices = {"x", "y", "z"}}};
  Parameter<double> duration{this,
                             "duration",
                             {.unit = "s",
                              .initial = "60 s",
                              .min = "0.1 s",
                              .max = "86400 s",
                              .doc = "of the whole course, from the run's start"}};
  Parameter<double> ramp{this,
                         "ramp",
                         {.initial = "0.2",
                          .min = "0",
                          .max = "0.75",
                          .doc = "share of a dwell that the move to its level takes"}};

 private:
  LoadCourse course_;
};

}  // namespace trocar
