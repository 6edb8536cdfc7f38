// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/devices/command_receiver.hpp"
#include "components/devices/drive_parameters.hpp"
#include "components/devices/handle_cap_parameters.hpp"
#include "components/devices/laparoscope_device_limits.hpp"
#include "components/devices/laparoscope_loads.hpp"
#include "components/devices/laparoscope_use_parameters.hpp"
#include "components/devices/link_parameters.hpp"
#include "components/devices/mechanism_parameters.hpp"
#include "components/devices/simulated_hand_parameters.hpp"
#include "components/devices/simulated_truth.hpp"
#include "components/kinematics/laparoscope_limit_parameters.hpp"
#include "components/kinematics/laparoscope_parameters.hpp"
#include "framework/device.hpp"

namespace trocar {

/// The laparoscopic interface as a simulation: LaparoscopePlant behind a firmware with transport
/// delay, watchdog and brake, seeded by the run.
///
///   report of tick k:   the plant has moved to t_k under what acted until then; the encoders were
///                       sampled up to report_jitter before, and a lost report leaves the last
///   command of tick k:  acts from t_k + delay T on; zero 8 ms after the last one arrived
///
/// `effort_applied` changes as the command is taken: in a tick others read what acted until t_k,
/// a row holds what acts from t_k on, which is `effort_sent` of `delay` ticks before, rounded up.
/// Loads act on the tool itself, from the tick in which they are computed to the next, and never
/// through motors or gate.
///
/// Skipped slots pass for the plant as for everybody, up to 1 s at a time.
///
/// start = engaged: at rest, homed, dead-man pressed, held by the firmware's own gravity model
/// until commands arrive. start = cold: a parking brake locks the axes, and time stands still for
/// plant and hand, until the command holds the weight by the firmware's model within 1 % and
/// 0.02 N or 2 mN m on every axis; without `hold` it stays locked.
class SimulatedLaparoscope final : public Device {
 public:
  SimulatedLaparoscope();
  /// @throw std::invalid_argument for settings that no device can have, or a starting pose that
  /// cannot be assembled or violates a limit.
  void configure(const Setup& setup) override;
  void start() override;
  void step(const Tick& tick) RT_SAFE override;
  const DeviceLimits& limits() const override { return limits_; }
  bool starts_engaged() const override { return use.start->index == 0; }
  /// What the parameters make of the plant.
  LaparoscopePlantSettings plant_settings(const Setup& setup) const;

  Input<Joints> hold{this, "hold", command("holds the weight; without it nothing does")};
  Input<Joints> effort{this, "effort", command("to be rendered")};
  Inputs<Vector3> tip_load{this, "tip_load", load("on the tool's tip, from outside")};
  Inputs<Vector3> incision_load{this, "incision_load", load("on the incision's point")};
  Inputs<Vector3> handle_load{this, "handle_load", load("on the handle")};

  Output<Joints> device_position{
      this, "position", {.unit = laparoscope_position_units, .doc = "that the encoders report"}};
  Output<Joints> effort_sent{
      this, "effort_sent", {.unit = laparoscope_effort_units, .doc = "what the gate let pass"}};
  Output<Joints> effort_applied{
      this,
      "effort_applied",
      {.unit = laparoscope_effort_units, .doc = "what the amplifiers make, hold included"}};
  Output<double> scale{this, "scale", {.doc = "share of `effort` that the gate let pass"}};
  Output<double> report_age{
      this, "report_age", {.unit = "s", .doc = "of `position`: since the encoders were sampled"}};
  SimulatedTruth truth{this};

  MountParameter mount{this};
  LaparoscopeUseParameters use{this};
  Parameter<Vector3> start_position{
      this, "start_position", {.unit = "m", .initial = "0, 0, 85 mm", .doc = "of E"}};
  Parameter<Vector3> start_angles{
      this, "start_angles", {.unit = "deg", .initial = "0, 0, 0", .doc = "alpha, beta, theta"}};
  LaparoscopeSiteParameters sites{this};
  SimulatedHandParameters hand{this};
  DriveParameters drives{this};
  MechanismParameters mechanism{this};
  LinkParameters link{this};
  Parameter<double> physics_step{this,
                                 "physics_step",
                                 {.unit = "s",
                                  .initial = "0.1 ms",
                                  .min = "0.001 ms",
                                  .max = "0.1 ms",
                                  .doc = "at most; there are at least 4 in a tick"}};
  HandleCapParameters caps{this};
  LaparoscopeGeometryParameters geometry{this};
  LaparoscopeMassParameters masses{this};
  LaparoscopeLimitParameters ranges{this};

 private:
  DeviceStatus status() const RT_SAFE override;
  void tool_loads(const Joints& effort, ToolLoads& loads) const RT_SAFE override;
  double handle_speed(const Joints& velocity) const RT_SAFE override;
  Joints weight() const RT_SAFE override;
  void write(const Tick& tick, const GatedEffort& effort) RT_SAFE override;

  AssemblyStatus own_weight(const Vector6d& position, Vector6d& holding) const RT_SAFE;
  void pass(std::int64_t period) RT_SAFE;
  void move_through(std::int64_t period, std::int64_t sampled_ns) RT_SAFE;
  void act(const Vector6d& command) RT_SAFE;
  void move(std::int64_t duration_ns) RT_SAFE;
  bool brake_lets_go() RT_SAFE;
  Vector6d external_wrench() const RT_SAFE;
  void report(double since_last) RT_SAFE;
  void report_truth(double since_last) RT_SAFE;

  static PortOptions command(const char* doc) {
    return {.unit = laparoscope_effort_units, .doc = doc, .optional = true, .feedthrough = false};
  }
  static PortOptions load(const char* doc) {
    return {.unit = "N", .frame = "device", .doc = doc, .feedthrough = false};
  }

  std::optional<LaparoscopePlant> plant_;
  std::optional<LaparoscopeLoads> loads_;
  std::optional<CommandReceiver> receiver_;
  std::optional<ReportChannel> reports_;
  std::optional<LaparoscopeGravity> weight_model_;     // the driver's own
  Eigen::Vector3d gravity_ = Eigen::Vector3d::Zero();  // in N [m/s^2]
  DeviceLimits limits_ = laparoscope_device_limits({}, 1e-3);
  std::int64_t period_ns_ = 1'000'000;
  std::int64_t period_ = -1;              // of the last report, -1 before the first
  Vector6d weight_ = Vector6d::Zero();    // [N, N m] at the start, by the firmware's model
  Vector6d sampled_ = Vector6d::Zero();   // by the encoders, last [m, rad]
  Vector6d received_ = Vector6d::Zero();  // of that, what arrived last
  std::int64_t received_at_ns_ = 0;       // when that was sampled
  AssemblyStatus reported_ = AssemblyStatus::ok;
  bool braked_ = false;
};

}  // namespace trocar
