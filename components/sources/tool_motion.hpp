// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/sources/chirp.hpp"
#include "framework/component.hpp"

namespace trocar {

/// Where a motion along a line is, and its derivatives.
struct MotionPoint {
  double offset = 0.0;        // [m]
  double velocity = 0.0;      // [m/s]
  double acceleration = 0.0;  // [m/s^2]
  bool steady = false;        // at a constant speed
};

/// A LinearSweep with its derivatives, exact between the tapers and in them.
MotionPoint sweep_motion(const LinearSweep& sweep, double t) RT_SAFE;

/// To and fro between 0 and a stroke at a constant speed, over and over; speed and stroke have a
/// sign. Each end is a turn of constant acceleration beyond the stroke:
///
///   turn time 2 v / a, overshoot v² / (2 a)         first away from rest
struct Shuttle {
  double stroke = 0.040;      // S [m], > 0
  double speed = 0.050;       // v [m/s], > 0
  double acceleration = 1.0;  // a [m/s^2], > 0
  MotionPoint at(double t) const RT_SAFE;
};

/// A motion of a point along one axis of the base frame, known beforehand with its derivatives: for
/// servos, feed-forward and carriages that move a tool.
class ToolMotion : public Component {
 public:
  void step(const Tick& tick) RT_SAFE override;

  Output<Vector3> offset{
      this, "offset", {.unit = "m", .frame = "device", .doc = "from where it starts"}};
  Output<Vector3> velocity{this, "velocity", {.unit = "m/s", .frame = "device", .doc = "of it"}};
  Output<Vector3> acceleration{
      this, "acceleration", {.unit = "m/s^2", .frame = "device", .doc = "of it"}};
  Output<bool> steady{
      this, "steady", {.doc = "it moves at a constant speed, where a mean may look"}};

  Parameter<Choice> axis{this,
                         "axis",
                         {.initial = "z",
                          .doc = "of the device's base frame, along which it goes",
                          .choices = {"x", "y", "z"}}};
  Parameter<double> begin{
      this,
      "begin",
      {.unit = "s", .initial = "0 s", .min = "0 s", .doc = "of the motion; it is at rest before"}};
  Parameter<double> lead{this,
                         "lead",
                         {.unit = "s",
                          .initial = "0 s",
                          .min = "0 s",
                          .max = "0.1 s",
                          .doc = "by which it is ahead: the delay that it is to make up for"}};

 protected:
  virtual MotionPoint at(double t) const RT_SAFE = 0;
};

/// A chirp along a line: LinearSweep.
class ChirpMotion final : public ToolMotion {
 public:
  /// @throw std::invalid_argument for tapers that overlap.
  void configure(const Setup& setup) override;

  Parameter<double> amplitude{
      this,
      "amplitude",
      {.unit = "m", .min = "0 mm", .max = "500 mm", .doc = "of the swing between the tapers"}};
  Parameter<double> from{this,
                         "from",
                         {.unit = "Hz",
                          .initial = "0.1 Hz",
                          .min = "0 Hz",
                          .max = "100 Hz",
                          .doc = "frequency at the beginning"}};
  Parameter<double> to{this,
                       "to",
                       {.unit = "Hz",
                        .initial = "1 Hz",
                        .min = "0 Hz",
                        .max = "100 Hz",
                        .doc = "frequency at the end"}};
  Parameter<double> duration{this,
                             "duration",
                             {.unit = "s",
                              .initial = "20 s",
                              .min = "0.1 s",
                              .max = "3600 s",
                              .doc = "from beginning to end"}};
  Parameter<double> taper{this,
                          "taper",
                          {.unit = "s",
                           .initial = "0 s",
                           .min = "0 s",
                           .doc = "of the rise at the beginning and of the fall at the end"}};

 private:
  MotionPoint at(double t) const RT_SAFE override;
  LinearSweep sweep_;
};

/// To and fro at a constant speed: Shuttle.
class ShuttleMotion final : public ToolMotion {
 public:
  void configure(const Setup& setup) override;

  Parameter<double> stroke{
      this,
      "stroke",
      {.unit = "m", .initial = "40 mm", .min = "0.1 mm", .max = "500 mm", .doc = "of each way"}};
  Parameter<double> speed{
      this,
      "speed",
      {.unit = "m/s", .initial = "0.05 m/s", .min = "1 mm/s", .max = "2 m/s", .doc = "of it"}};
  Parameter<double> turning{this,
                            "turning",
                            {.unit = "m/s^2",
                             .initial = "1 m/s^2",
                             .min = "0.01 m/s^2",
                             .max = "50 m/s^2",
                             .doc = "acceleration at the ends, beyond the stroke"}};

 private:
  MotionPoint at(double t) const RT_SAFE override;
  Shuttle shuttle_;
};

}  // namespace trocar
