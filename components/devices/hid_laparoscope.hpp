// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/devices/handle_cap_parameters.hpp"
#include "components/devices/hid/axis_scale.hpp"
#include "components/devices/hid_device_parameters.hpp"
#include "components/devices/hid_device_ports.hpp"
#include "components/devices/hid_laparoscope_parameters.hpp"
#include "components/devices/laparoscope_device_limits.hpp"
#include "components/kinematics/laparoscope_gravity.hpp"
#include "components/kinematics/laparoscope_limit_parameters.hpp"
#include "components/kinematics/laparoscope_parameters.hpp"
#include "framework/device.hpp"

namespace trocar {

namespace hid {
class DeviceLine;
struct DeviceLineSettings;
}  // namespace hid

/// The laparoscopic interface itself, over USB HID (docs/device-protocol.md).
///
/// The graph is built and checked by the parameters, without the device. When a run starts the
/// device is looked for, and refused where its own pages say otherwise. Two threads of its own read
/// and write; each tick takes the newest report, and its command is sent once.
///
/// Until the device is homed, and for 25 ms more, `position` is that of unhomed_position, and
/// nothing is sent. A report older than report_stale ends everything. After the device was gone, it
/// is taken again when it comes back as the same one: home it, where it asks for that, then
/// acknowledge.
class HidLaparoscope : public Device {
 public:
  HidLaparoscope();
  ~HidLaparoscope() override;
  /// @throw std::invalid_argument for settings that no device can have, or a rate that its watchdog
  /// does not allow
  void configure(const Setup& setup) override;
  /// @throw std::runtime_error when the device is not there, may not be opened, does not answer or
  /// is another one
  void start() override;
  void step(const Tick& tick) RT_SAFE override;
  void stop() override;
  const DeviceLimits& limits() const override { return limits_; }
  bool needs_real_time() const override { return true; }
  bool paces() const override { return true; }
  Pacer* pacer() override;

  Input<Joints> hold{this, "hold", command("holds the weight; without it nothing does")};
  Input<Joints> effort{this, "effort", command("to be rendered")};
  Output<Joints> device_position{
      this, "position", {.unit = laparoscope_position_units, .doc = "that the encoders report"}};
  Output<Joints> effort_sent{
      this, "effort_sent", {.unit = laparoscope_effort_units, .doc = "what the gate let pass"}};
  Output<Joints> effort_applied{
      this,
      "effort_applied",
      {.unit = laparoscope_effort_units, .doc = "as the device reports it, hold included"}};
  Output<double> scale{this, "scale", {.doc = "share of `effort` that the gate let pass"}};
  HidDevicePorts told{this};

  HidDeviceParameters which{this};
  MountParameter mount{this};
  LaparoscopeSiteParameters sites{this};
  HidLaparoscopeParameters own{this};
  HandleCapParameters caps{this};
  LaparoscopeGeometryParameters geometry{this};
  LaparoscopeMassParameters masses{this};
  LaparoscopeLimitParameters ranges{this};

 protected:
  /// What it gets its reports from; a test has another one.
  virtual std::unique_ptr<hid::DeviceLine> line(const hid::DeviceLineSettings& settings);

 private:
  DeviceStatus status() const RT_SAFE override { return status_; }
  void tool_loads(const Joints& effort, ToolLoads& loads) const RT_SAFE override;
  double handle_speed(const Joints& velocity) const RT_SAFE override;
  Joints weight() const RT_SAFE override { return weight_; }
  void write(const Tick& tick, const GatedEffort& effort) RT_SAFE override;
  void loop_stalled() override;

  void observe() RT_SAFE;
  hid::PostedCommand begin_command() RT_SAFE;
  void take_position(const hid::DeviceSnapshot& snapshot) RT_SAFE;
  DeviceStatus judge(const hid::DeviceSnapshot& snapshot) const RT_SAFE;

  static PortOptions command(const char* doc) {
    return {.unit = laparoscope_effort_units, .doc = doc, .optional = true, .feedthrough = false};
  }

  std::unique_ptr<hid::DeviceLine> line_;
  std::optional<hid::AxisScale> scaling_;
  std::optional<LaparoscopeLoads> loads_;
  std::optional<LaparoscopeModel> model_;
  std::optional<LaparoscopeGravity> weight_model_;
  Eigen::Vector3d gravity_ = Eigen::Vector3d::Zero();  // in N [m/s^2]
  DeviceLimits limits_ = laparoscope_device_limits({}, 1e-3);
  std::int64_t period_ns_ = 1'000'000;
  Vector6d unhomed_position_ = Vector6d::Zero();
  Joints weight_{};
  DeviceStatus status_{};
  AssemblyStatus assembled_ = AssemblyStatus::ok;
  std::int64_t homed_since_ns_ = 0;    // 0: it is not
  std::int64_t begun_ns_ = 0;          // when the tick began
  std::uint32_t begun_device_us_ = 0;  // the same in device time, as far as it is known
  std::int64_t posted_ = 0;
};

}  // namespace trocar
