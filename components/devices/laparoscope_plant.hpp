// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "components/devices/end_stops.hpp"
#include "components/devices/laparoscope_drive.hpp"
#include "components/devices/motor_temperature.hpp"
#include "components/devices/series_compliance.hpp"
#include "components/devices/simulated_hand.hpp"
#include "components/kinematics/laparoscope_dynamics.hpp"

namespace trocar {

struct LaparoscopePlantSettings {
  LaparoscopeGeometry geometry = {};
  LaparoscopeMasses masses = {};
  LaparoscopeLimits limits = {};
  LaparoscopeDriveSettings drive = {};
  EndStopSettings stops = {};
  HandSettings hand = {};
  Imperfections imperfections = {};
  Eigen::Vector3d gravity = standard_gravity;  // in N [m/s^2], turned with the mount
  PoseCoordinates start{{0.0, 0.0, 0.085}, 0.0, 0.0, 0.0};
  std::uint64_t seed = 1;  // of gains, phases of ripple and cogging, homing errors
};

/// The simulated laparoscopic interface with its drives, friction, stops and the hand.
///
///   (M + m_h Jv^T Jv) q'' = tau - tau_g - c - friction - stops + J^T (F_hand + F_external)
///
/// With compliance the motors (SeriesCompliance) are apart: tau and friction act on them, and the
/// mechanism, without their inertia and weight, is driven by the springs instead.
///
/// Second order in the step while the motion is smooth: half a step of drift, a kick with
/// the forces there, half a step of drift. Damping enters the kick by the trapezoidal
/// rule, dry friction sticks exactly: at rest below its level a motor does not move by a bit.
class LaparoscopePlant {
 public:
  /// @throw std::invalid_argument when a setting or the starting pose is impossible.
  explicit LaparoscopePlant(const LaparoscopePlantSettings& settings = {});

  /// Places the device; the hand keeps what it holds. @throw as the constructor
  void place(const Vector6d& q, const Vector6d& velocity);

  /// Command that the drives hold until the next call [N, N m].
  void apply(const Vector6d& effort) RT_SAFE {
    command_ = drive_.sent(effort);
    sent_ = temperature_.limited(command_);
  }

  /// (force; moment about E) from outside, in N, held until the next call.
  void load(const Vector6d& wrench) RT_SAFE { external_ = wrench; }

  /// Moves on by `duration` [s] in `substeps` equal steps, none longer than longest_step(). A
  /// mechanism that came apart (see status()) stays where it was, at rest.
  void advance(double duration, int substeps) RT_SAFE;

  /// Steps of at most 0.1 ms, at least 4.
  static int substeps(double duration) RT_SAFE;
  /// That the transmission's springs allow [s].
  double longest_step() const { return springs_ ? springs_->longest_step() : HUGE_VAL; }

  const Vector6d& position() const RT_SAFE { return q_; }  // of the mechanism
  const Vector6d& velocity() const RT_SAFE { return v_; }
  const Vector6d& motor_position() const RT_SAFE { return springs_ ? springs_->position() : q_; }
  Vector6d measured_position() const RT_SAFE { return drive_.read(motor_position()); }
  const Vector6d& sent_effort() const RT_SAFE { return sent_; }
  const LaparoscopeConfiguration& configuration() const RT_SAFE { return here_; }  // at position()
  double time() const RT_SAFE { return time_; }                                    // [s]
  AssemblyStatus status() const RT_SAFE { return status_; }
  const LaparoscopeDynamics& dynamics() const RT_SAFE { return dynamics_; }
  const LaparoscopeDrive& drive() const RT_SAFE { return drive_; }
  const MotorTemperature& temperature() const RT_SAFE { return temperature_; }
  /// What the mechanism gets of an effort that is sent, ripple aside.
  Vector6d gain() const RT_SAFE { return drive_.gain().cwiseProduct(temperature_.gain()); }
  const SimulatedHand& hand() const RT_SAFE { return hand_; }

  /// Kinetic energy with the hand's, and potential of weight, stops, transmission and the hand's
  /// springs [J].
  double energy() const RT_SAFE;

 private:
  /// All that acts on the mechanism in the kick besides the drives.
  struct Actions {
    Matrix6d mass;     // with the hand's
    Matrix6d damping;  // of hand and stops
    Vector6d effort;   // [N, N m]
  };

  Actions actions(const LaparoscopeConfiguration& configuration, double time) const RT_SAFE;
  void add_hand(const LaparoscopeConfiguration& configuration, const LaparoscopeRates& rates,
                const LaparoscopeDynamics::Bias& bias, double time, Actions& sum) const RT_SAFE;
  void step(double h, double time) RT_SAFE;
  Vector6d kick_as_one(double h, const Actions& actions) const RT_SAFE;
  Vector6d kick_apart(double h, const Actions& actions) RT_SAFE;
  void settle() RT_SAFE;

  LaparoscopeDynamics dynamics_;
  LaparoscopeDrive drive_;
  MotorTemperature temperature_;
  std::optional<SeriesCompliance> springs_;
  EndStops stops_;
  SimulatedHand hand_;
  Eigen::Vector3d gravity_;
  LaparoscopeConfiguration here_;
  Vector6d q_ = Vector6d::Zero();
  Vector6d v_ = Vector6d::Zero();
  Vector6d v_before_ = Vector6d::Zero();      // one step earlier
  Vector6d motor_weight_ = Vector6d::Zero();  // on the motors' side of the springs [N, N m]
  Vector6d command_ = Vector6d::Zero();
  Vector6d sent_ = Vector6d::Zero();  // of command_, what the motors' temperature allows
  Vector6d pull_ = Vector6d::Zero();  // sent_ as warm magnets have it
  Vector6d external_ = Vector6d::Zero();
  double time_ = 0.0;
  AssemblyStatus status_ = AssemblyStatus::ok;
};

}  // namespace trocar
