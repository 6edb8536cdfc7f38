// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

#include "framework/component.hpp"
#include "framework/pacer.hpp"

namespace trocar {

class Gate;
class Supervisor;

/// What a device that has states of its own is asked to be in. One that has none ignores it.
enum class DeviceMode {
  off,     // nothing is sent, and nothing is to be held
  hold,    // its weight, and damping
  render,  // and effort, once its own rules to engage are met
  home     // find its references
};

/// Effort that passed the gate. Only a Gate can make one, and a device's write() takes nothing
/// else: that is why no component, script or plugin has a way to the motors round it.
class GatedEffort {
 public:
  const Joints& effort() const RT_SAFE { return effort_; }  // [N or N m], hold included
  /// Of it, what stays when a device lets no effort pass: hold, and damping while nothing renders.
  const Joints& hold() const RT_SAFE { return hold_; }
  std::int64_t tick() const RT_SAFE { return tick_; }
  std::int64_t deadline_ns() const RT_SAFE { return deadline_ns_; }  // not valid after it
  DeviceMode mode() const RT_SAFE { return mode_; }
  /// The operator acknowledges what the device itself latched; counts when it rises.
  bool acknowledges() const RT_SAFE { return acknowledges_; }

  // Written out so that the type is not trivially copyable, or std::bit_cast could make one.
  ~GatedEffort() {}
  GatedEffort(const GatedEffort&) = delete;
  GatedEffort& operator=(const GatedEffort&) = delete;

 private:
  friend class Gate;
  GatedEffort(const Joints& effort, std::int64_t tick, std::int64_t deadline_ns) RT_SAFE
      : effort_(effort),
        tick_(tick),
        deadline_ns_(deadline_ns) {}
  Joints effort_;
  std::int64_t tick_;
  std::int64_t deadline_ns_;
  Joints hold_{};
  DeviceMode mode_ = DeviceMode::off;
  bool acknowledges_ = false;
};

/// What a device can bear, for each axis. All must be declared: an unset limit is a finding.
struct DeviceLimits {
  static constexpr double undeclared = -1.0;
  int axes = 0;
  Joints effort;           // [N or N m] peak
  Joints rise;             // [N/s or N m/s] of rendered effort
  Joints speed;            // [m/s or rad/s]
  Joints lowest, highest;  // [m or rad] mechanical range
  Joints margin;           // [m or rad] beyond the range that is a trip: a stop yields that much
  Joints jump;             // [m or rad] between two reports that no motion can explain
  Joints damping;          // [N s/m or N m s/rad] that stays when rendering is off
  Joints damping_cap;      // [N or N m] at most
  Joints hold_tolerance;   // [N or N m] that hold may differ from the device's own weight
  double handle_speed = undeclared;  // [m/s]

  DeviceLimits() {
    for (Joints* each :
         {&effort, &rise, &speed, &margin, &jump, &damping, &damping_cap, &hold_tolerance})
      for (double& value : each->axis) value = undeclared;
  }
  /// The names of the limits that were left undeclared.
  std::vector<std::string> missing() const;
};

/// Something that rendered effort loads besides the actuators: the hand on the handle, a stage.
struct ToolLoad {
  const char* what = "";
  Vector3 value;                                          // [N or N m]
  double cap = 0.0;                                       // rendering is scaled down to it
  double trip = std::numeric_limits<double>::infinity();  // raw value beyond it latches
  double calm = std::numeric_limits<double>::infinity();  // to engage, it must be below
};

struct ToolLoads {
  std::array<ToolLoad, 8> load;
  int count = 0;
  /// One more than fit trips: a load that nobody watches must not go unnoticed.
  void add(const ToolLoad& one) RT_SAFE {
    if (static_cast<std::size_t>(count) < load.size())
      load[static_cast<std::size_t>(count++)] = one;
    else
      load.back() = {.what = "more tool loads than fit", .value = {}, .trip = -1.0};
  }
};

/// What a device reports of itself beside its position.
struct DeviceStatus {
  bool position_valid = true;   // fresh and plausible
  const char* why = "";         // it is not, or not homed
  bool homed = true;            // until then the gate sends nothing, and the position may step
  bool dead_man = true;         // pressed, in the device's own report
  bool renders = true;          // its own rules to engage are met: it lets effort pass
  const char* fault = nullptr;  // that it latched by itself, until acknowledged: a constant text
  bool holds = true;            // with that fault it still holds its weight
};

/// A component with motors. At a tick the executor steps it first (it reports its position), then
/// everybody else, then the gate writes `hold` and `effort` to it.
class Device : public Component {
 public:
  Output<Joints>& position() { return *position_; }
  const InputPort& hold_port() const { return *hold_; }
  const InputPort& effort_port() const { return *effort_; }
  const OutputPort& effort_sent_port() const { return *effort_sent_; }
  virtual const DeviceLimits& limits() const = 0;
  /// The device starts at rest, engaged, hold full: a simulation may, hardware may not.
  virtual bool starts_engaged() const { return false; }
  /// It is a thing of its own: virtual time would leave it behind.
  virtual bool needs_real_time() const { return false; }
  /// Its reports may begin the ticks of its thread, by pacer().
  virtual bool paces() const { return false; }
  /// From start() on, where it paces.
  virtual Pacer* pacer() { return nullptr; }

 protected:
  /// Called by the subclass's constructor with its ports.
  void declare_device(Output<Joints>& position, Input<Joints>& hold, Input<Joints>& effort,
                      Output<Joints>& effort_sent, Output<double>& scale) {
    position_ = &position;
    hold_ = &hold;
    effort_ = &effort;
    effort_sent_ = &effort_sent;
    scale_ = &scale;
  }

 private:
  friend class Gate;
  friend class Supervisor;
  virtual DeviceStatus status() const RT_SAFE = 0;
  /// What `effort` loads at the present position, by the driver's own kinematics and never by
  /// values from ports. Linear in effort.
  virtual void tool_loads(const Joints& effort, ToolLoads& loads) const RT_SAFE = 0;
  /// [m/s] of the handle for axis velocities, by the driver's own kinematics.
  virtual double handle_speed(const Joints& velocity) const RT_SAFE = 0;
  /// The effort that holds it at the present position, by the driver's own model. `hold` passes
  /// the gate without ramps and outlives faults, so it must be a weight and nothing else.
  virtual Joints weight() const RT_SAFE = 0;
  virtual void write(const Tick& tick, const GatedEffort& effort) RT_SAFE = 0;
  /// The loop hangs: send what is safe without it. Called by the supervisor's thread while the loop
  /// may be in any other function of this device. A device whose watchdog is its own needs nothing.
  virtual void loop_stalled() {}

  bool has_gate_ = false;  // while it has one, nobody can make another
  Output<Joints>* position_ = nullptr;
  Input<Joints>* hold_ = nullptr;
  Input<Joints>* effort_ = nullptr;
  Output<Joints>* effort_sent_ = nullptr;
  Output<double>* scale_ = nullptr;
};

}  // namespace trocar
