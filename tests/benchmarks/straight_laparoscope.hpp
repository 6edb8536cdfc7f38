// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "components/devices/command_receiver.hpp"
#include "components/devices/laparoscope_device_limits.hpp"
#include "components/devices/laparoscope_loads.hpp"
#include "components/devices/laparoscope_plant.hpp"
#include "components/filters/foaw.hpp"
#include "components/fixtures/wall.hpp"
#include "framework/axis_velocity.hpp"

namespace trocar::bench {

struct StraightSettings {
  LaparoscopePlantSettings plant;
  LaparoscopeMasses nominal;  // by which the weight is held
  FlatWall wall;              // that the tip touches
  double period = 1e-3;       // [s]
  int delay = 1;              // [ticks] of a command
  int substeps = 10;          // of the plant in a tick
};

/// What the graph of the tutorial "feel a wall" computes in a tick, written down as one straight
/// calculation: plant, velocity, kinematics, weight, wall, statics, and the checks and limits of
/// the gate. The classes that calculate are those of the components; there are no ports, no graph,
/// no executor, and no choices that this one device with this one wall does not have.
///
/// The forward kinematics of tool and weight is shared. That of the driver, by which it watches
/// its loads and its hold, is its own, as safety wants it.
class StraightLaparoscope {
 public:
  explicit StraightLaparoscope(const StraightSettings& settings);
  /// Ticks come one after the other, from 0.
  void tick() RT_SAFE;

  // Of the last tick, as the graph's outputs of these names.
  Vector6d position = Vector6d::Zero();     // [m, rad]
  Vector6d effort_sent = Vector6d::Zero();  // [N, N m]
  Vector6d effort = Vector6d::Zero();       // [N, N m]
  PointMotion tip, incision, handle, truth_tip;
  Pose pose;
  Vector3 angles;
  Twist twist;
  FlatWall::Contact contact;
  Vector3 hand_force;    // [N]
  double scale = 0.0;    // share of `effort` that is sent
  bool tripped = false;  // for good: nothing is rendered any more

 private:
  void move() RT_SAFE;
  void measure_velocity() RT_SAFE;
  void compute_forces() RT_SAFE;
  bool position_is_safe() RT_SAFE;
  bool hold_is_safe() const RT_SAFE;
  double safe_scale() RT_SAFE;
  void send() RT_SAFE;
  double now() const RT_SAFE { return static_cast<double>(tick_) * settings_.period; }  // [s]

  StraightSettings settings_;
  LaparoscopePlant plant_;
  LaparoscopeLoads loads_;
  LaparoscopeModel model_;
  LaparoscopeGravity weight_;
  CommandReceiver receiver_;
  DeviceLimits limits_;
  std::array<AdaptiveWindow, 6> windows_;
  AxisVelocity axis_velocity_;
  std::int64_t tick_ = 0;
  Vector6d velocity_ = Vector6d::Zero();  // [m/s, rad/s]
  Vector6d hold_ = Vector6d::Zero();      // [N, N m]
  Vector6d rendered_ = Vector6d::Zero();  // [N, N m] in the tick before
  Vector6d position_before_ = Vector6d::Zero();
};

}  // namespace trocar::bench
