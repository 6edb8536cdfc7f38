// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/devices/command_receiver.hpp"
#include "components/devices/laparoscope_device_limits.hpp"
#include "components/devices/laparoscope_loads.hpp"
#include "components/devices/laparoscope_plant.hpp"
#include "components/devices/simulated_laparoscope_parameters.hpp"
#include "components/kinematics/laparoscope_limit_parameters.hpp"
#include "components/kinematics/laparoscope_parameters.hpp"
#include "components/kinematics/laparoscope_units.hpp"
#include "framework/device.hpp"

namespace trocar {

/// The laparoscopic interface as a simulation: LaparoscopePlant behind a firmware with transport
/// delay, watchdog and brake, seeded by the run.
///
///   report of tick k:   the plant has moved to t_k under what acted until then
///   command of tick k:  acts from t_(k+delay) on; zero 8 ms after the last one arrived
///
/// `effort_applied` changes as the command is taken: in a tick others read what acted until t_k,
/// a row holds what acts from t_k on, which is `effort_sent` of `delay` ticks before. Loads act on
/// the tool itself, from the tick in which they are computed to the next, and never through motors
/// or gate.
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
  Output<Joints> truth_position{
      this, "truth.position", {.unit = laparoscope_position_units, .doc = "where the axes are"}};
  Output<Joints> truth_velocity{
      this, "truth.velocity", {.unit = laparoscope_velocity_units, .doc = "of the axes"}};
  Output<PointMotion> truth_tip{this, "truth.tip", {.frame = "device", .doc = "motion of E"}};
  Output<Vector3> truth_hand_force{
      this,
      "truth.hand_force",
      {.unit = "N", .frame = "device", .doc = "of the hand on the tool at E"}};

  MountParameter mount{this};
  LaparoscopeUseParameters use{this};
  Parameter<Vector3> start_position{
      this, "start_position", {.unit = "m", .initial = "0, 0, 85 mm", .doc = "of E"}};
  Parameter<Vector3> start_angles{
      this, "start_angles", {.unit = "deg", .initial = "0, 0, 0", .doc = "alpha, beta, theta"}};
  LaparoscopeSiteParameters sites{this};
  SimulatedHandParameters hand{this};
  ImperfectionParameters imperfections{this};
  Parameter<std::int64_t> delay{
      this,
      "delay",
      {.initial = "1", .min = "0", .max = "2", .doc = "[ticks] until a command acts"}};
  Parameter<double> physics_step{this,
                                 "physics_step",
                                 {.unit = "s",
                                  .initial = "0.1 ms",
                                  .min = "0.001 ms",
                                  .max = "0.1 ms",
                                  .doc = "at most; there are at least 4 in a tick"}};
  Parameter<double> handle_force_cap{this,
                                     "handle_force_cap",
                                     {.unit = "N",
                                      .initial = "20 N",
                                      .min = "1 N",
                                      .max = "100 N",
                                      .doc = "of what is rendered; twice it trips",
                                      .live = true}};
  Parameter<double> handle_moment_cap{this,
                                      "handle_moment_cap",
                                      {.unit = "N m",
                                       .initial = "1 N m",
                                       .min = "0.05 N m",
                                       .max = "5 N m",
                                       .doc = "of what is rendered; twice it trips",
                                       .live = true}};
  LaparoscopeGeometryParameters geometry{this};
  LaparoscopeMassParameters masses{this};
  LaparoscopeLimitParameters ranges{this};

 private:
  DeviceStatus status() const RT_SAFE override;
  void tool_loads(const Joints& effort, ToolLoads& loads) const RT_SAFE override;
  double handle_speed(const Joints& velocity) const RT_SAFE override;
  Joints weight() const RT_SAFE override;
  void write(const Tick& tick, const GatedEffort& effort) RT_SAFE override;

  LaparoscopePlantSettings plant_settings(const Setup& setup) const;
  AssemblyStatus own_weight(const Vector6d& position, Vector6d& holding) const RT_SAFE;
  void pass(std::int64_t period) RT_SAFE;
  void move(std::int64_t duration_ns) RT_SAFE;
  bool brake_lets_go() RT_SAFE;
  Vector6d external_wrench() const RT_SAFE;
  void report(double since_last) RT_SAFE;

  static PortOptions command(const char* doc) {
    return {.unit = laparoscope_effort_units, .doc = doc, .optional = true, .feedthrough = false};
  }
  static PortOptions load(const char* doc) {
    return {.unit = "N", .frame = "device", .doc = doc, .feedthrough = false};
  }

  std::optional<LaparoscopePlant> plant_;
  std::optional<LaparoscopeLoads> loads_;
  std::optional<CommandReceiver> receiver_;
  std::optional<LaparoscopeGravity> weight_model_;     // the driver's own
  Eigen::Vector3d gravity_ = Eigen::Vector3d::Zero();  // in N [m/s^2]
  DeviceLimits limits_ = laparoscope_device_limits({}, 1e-3);
  std::int64_t period_ns_ = 1'000'000;
  std::int64_t period_ = -1;            // of the last report, -1 before the first
  Vector6d weight_ = Vector6d::Zero();  // [N, N m] at the start, by the firmware's model
  AssemblyStatus reported_ = AssemblyStatus::ok;
  bool braked_ = false;
};

}  // namespace trocar
