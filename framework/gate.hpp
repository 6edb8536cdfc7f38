// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "framework/axis_velocity.hpp"
#include "framework/device.hpp"
#include "framework/fault.hpp"

namespace trocar {

/// The only way to a device's motors. Each tick: finite → trips on raw values → engage ramp on
/// effort → limit → rise limit → finite → write.
///
///   sent = r_h hold + s effort,   s the largest in [0, r_e] with, for every actuator i and tool
///   load j,  |hold_i + s effort_i| <= limit_i,  |s load_j| <= cap_j,
///   |s effort_i| <= |s effort_i|_before + rise_i T  (from 0 where the sign changes)
///
/// One factor for all axes keeps the direction of the rendered wrench; r_h and r_e are the ramps
/// of hold (1 s) and engagement (0.5 s).
///
/// A trip latches. While the position is trusted it ends the rendering at once; hold and a capped
/// damping stay, so that the tool does not fall on the hand. When the position or hold itself is
/// wrong, or the device is not homed, nothing stays.
class Gate {
 public:
  enum class State { cold, holding, engaging, engaged, tripped };

  /// @throw std::logic_error when the device has a gate already: there is one way to its motors
  Gate(Device& device, double period, FaultLatch& faults);
  ~Gate() { device_.has_gate_ = false; }
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;

  /// Sends this tick's effort. `effort_usable` and `hold_usable` say whether everything that they
  /// are computed from was finite in this tick.
  void pass(const Tick& tick, bool effort_usable, bool hold_usable) RT_SAFE;

  /// Asks to render; granted when homed, no fault, dead-man pressed, and for 0.5 s the handle
  /// slower than 20 mm/s and every load below what the device calls calm; and when a device with
  /// rules of its own lets effort pass.
  void request_engage() RT_SAFE { engage_requested_ = true; }
  /// Ends rendering until acknowledged; latches `fault`.
  void stop_rendering(const Fault& fault) RT_SAFE;
  /// Leaves the tripped state, to holding and never to engaged, when nothing was wrong for 0.1 s.
  /// A fault that the device latched is acknowledged there as well; if it stays, it trips again.
  bool acknowledge() RT_SAFE;
  /// Asks a device that is not homed to find its references, after acknowledging there what it
  /// latched by itself. @return nullptr, or why not
  const char* request_home() RT_SAFE;

  State state() const RT_SAFE { return state_; }
  const Device& device() const { return device_; }
  /// [m/s or rad/s] by differences of the device's own reports, for trips and damping.
  const Joints& velocity() const RT_SAFE { return velocity_.value(); }

 private:
  static bool finite(const Joints& joints) RT_SAFE;
  void clear_device() RT_SAFE;
  void trip(FaultCause cause, const char* detail, double value, double limit) RT_SAFE;
  void watch_device(const DeviceStatus& status) RT_SAFE;
  void watch_position(const DeviceStatus& status) RT_SAFE;
  void watch_motion() RT_SAFE;
  double now() const RT_SAFE { return static_cast<double>(tick_.index) * period_; }  // [s]
  double periods_since_report() const RT_SAFE;
  void watch_hold() RT_SAFE;
  void watch_effort() RT_SAFE;
  void advance_state(const DeviceStatus& status) RT_SAFE;
  DeviceMode mode() const RT_SAFE;
  double largest_scale() const RT_SAFE;
  double risen_scale(double scale) const RT_SAFE;
  Joints command() RT_SAFE;
  double damping(int axis) const RT_SAFE;

  Device& device_;
  const DeviceLimits limits_;
  const double period_;
  FaultLatch& faults_;
  AxisVelocity velocity_;
  State state_;
  Tick tick_{};
  Joints position_before_{};
  std::int64_t reported_at_ = 0;  // slot
  Joints rendered_before_{};
  ToolLoads loads_{};  // of this tick's raw effort
  double hold_ramp_;
  double effort_ramp_;
  double calm_for_ = 0.0;   // [s] that the conditions to engage hold
  double sound_for_ = 0.0;  // [s] since anything was wrong
  bool homed_ = false;
  bool started_ = false;
  bool engage_requested_ = false;
  bool home_requested_ = false;
  bool device_renders_ = false;         // as of the tick before
  const char* device_fault_ = nullptr;  // that was tripped for
  double clearing_for_ = -1.0;          // [s] that the device is asked to clear it; below 0: is not
  bool position_lost_ = false;
  bool hold_lost_ = false;
  bool effort_lost_ = false;
};

const char* to_string(Gate::State state) RT_SAFE;

}  // namespace trocar
