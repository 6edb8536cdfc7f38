// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/straight_laparoscope.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trocar::bench {
namespace {

constexpr double force_cap = 20.0;   // [N] at the handle; twice it trips
constexpr double moment_cap = 1.0;   // [N m]
constexpr int deadline_periods = 3;  // after which a command is not valid any more

std::int64_t in_ns(double seconds) RT_SAFE {
  return std::llround(seconds * 1e9);
}

AdaptiveWindow window_of(double count) {
  return AdaptiveWindow({.band = count});
}

Joints joints(const Vector6d& numbers) RT_SAFE {
  Joints result;
  result.head<6>() = numbers;
  return result;
}

}  // namespace

StraightLaparoscope::StraightLaparoscope(const StraightSettings& settings)
    : settings_(settings),
      plant_(settings.plant),
      loads_(settings.plant.geometry, 0.0),
      model_(settings.plant.geometry),
      weight_(settings.plant.geometry, settings.nominal),
      receiver_(in_ns(settings.period), settings.delay),
      limits_(laparoscope_device_limits(settings.plant.limits, settings.period)),
      windows_{window_of(settings.plant.drive.slider.resolution),
               window_of(settings.plant.drive.slider.resolution),
               window_of(settings.plant.drive.slider.resolution),
               window_of(settings.plant.drive.ring.resolution),
               window_of(settings.plant.drive.ring.resolution),
               window_of(settings.plant.drive.ring.resolution)} {
  LaparoscopeConfiguration c;
  position = plant_.measured_position();
  model_.forward(position, c);
  receiver_.start(0, joints(weight_.effort(c, model_.rates(c), settings_.plant.gravity)));
  truth_tip.velocity = Eigen::Vector3d(Eigen::Vector3d::Zero());
}

void StraightLaparoscope::tick() RT_SAFE {
  move();
  measure_velocity();
  compute_forces();
  const bool safe = position_is_safe() && hold_is_safe();
  tripped = tripped || !safe;
  scale = safe_scale();
  send();
  position_before_ = position;
  ++tick_;
}

void StraightLaparoscope::move() RT_SAFE {
  if (tick_ > 0) {
    receiver_.begin(tick_ - 1);
    plant_.apply(receiver_.effort().head<6>());
    plant_.advance(settings_.period, settings_.substeps);
  }
  position = plant_.measured_position();
  tripped = tripped || loads_.update(position) != AssemblyStatus::ok;
  const LaparoscopeConfiguration& c = plant_.configuration();
  const Eigen::Vector3d before = truth_tip.velocity.eigen();
  const Eigen::Vector3d moving =
      plant_.dynamics().model().rates(c).jacobian.topRows<3>() * plant_.velocity();
  truth_tip = {c.tool.tip, moving};
  const HandSettings& hand = plant_.hand().settings();
  Eigen::Vector3d force = plant_.hand().spring_wrench(c.tool, plant_.time()).head<3>();
  force += hand.damping * (plant_.hand().target_velocity(plant_.time()) - moving);
  if (tick_ > 0) force -= hand.mass * (moving - before) / settings_.period;
  hand_force = force;
}

void StraightLaparoscope::measure_velocity() RT_SAFE {
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (tick_ == 0) windows_[i].reset(position[axis], settings_.period);
    velocity_[axis] = tick_ > 0 ? windows_[i].update(position[axis], settings_.period) : 0.0;
  }
}

void StraightLaparoscope::compute_forces() RT_SAFE {
  LaparoscopeConfiguration c;
  tripped = tripped || model_.forward(position, c) != AssemblyStatus::ok;
  const LaparoscopeRates rates = model_.rates(c);
  twist.eigen() = rates.jacobian * velocity_;
  const auto site = [&](double s) {
    const Eigen::Vector3d point = point_on_tool(c.tool, s);
    return PointMotion{point, Eigen::Vector3d(velocity_at(c.tool, point, twist.eigen()))};
  };
  tip = site(0.0);
  incision = site(0.0);
  handle = site(0.0);
  pose = {c.tool.tip, Rotation(Eigen::Quaterniond(c.tool.rotation))};
  const PoseCoordinates coordinates = c.tool.pose();
  angles = {coordinates.alpha, coordinates.beta, coordinates.theta};
  hold_ = weight_.effort(c, rates, settings_.plant.gravity);
  contact = settings_.wall.touch(tip.position.eigen(), tip.velocity.eigen(), 0.0);
  Vector6d wrench;
  wrench << contact.force, (tip.position.eigen() - pose.position.eigen()).cross(contact.force);
  effort = rates.jacobian.transpose() * wrench;
}

/// By the driver's reports alone: no jump, no axis too fast or out of its range, nor the handle.
bool StraightLaparoscope::position_is_safe() RT_SAFE {
  if (!position.allFinite()) return false;
  if (tick_ == 0) axis_velocity_.reset(joints(position), now(), settings_.period);
  axis_velocity_.update(joints(position), now());
  const Joints& speed = axis_velocity_.value();
  bool safe = loads_.handle_speed(speed.head<6>()) <= limits_.handle_speed;
  for (int i = 0; i < 6; ++i) {
    const double beyond =
        std::max(limits_.lowest[i] - position[i], position[i] - limits_.highest[i]);
    safe = safe && std::abs(speed[i]) <= limits_.speed[i] && beyond <= limits_.margin[i];
    safe = safe && (tick_ == 0 || std::abs(position[i] - position_before_[i]) <= limits_.jump[i]);
  }
  return safe;
}

/// By the driver's own model: hold is a weight and nothing else.
bool StraightLaparoscope::hold_is_safe() const RT_SAFE {
  LaparoscopeConfiguration c;
  const LaparoscopeModel& own = plant_.dynamics().model();
  if (own.forward(position, c) != AssemblyStatus::ok) return false;
  const Vector6d weight = weight_.effort(c, own.rates(c), settings_.plant.gravity);
  bool safe = hold_.allFinite();
  for (int i = 0; i < 6; ++i)
    safe = safe && std::abs(hold_[i]) <= limits_.effort[i] &&
           std::abs(hold_[i] - weight[i]) <= limits_.hold_tolerance[i];
  return safe;
}

/// The share of `effort` that actuators, hand and stages bear, and that rises no faster than it
/// may.
double StraightLaparoscope::safe_scale() RT_SAFE {
  const LaparoscopeLoads::Loads on = loads_.of(effort);
  const double force = on.handle_force.norm(), moment = on.handle_moment.norm();
  tripped = tripped || !(force <= 2.0 * force_cap) || !(moment <= 2.0 * moment_cap);
  if (tripped) return 0.0;
  double share = 1.0;
  for (int i = 0; i < 6; ++i) {
    const double room = limits_.effort[i] - std::copysign(hold_[i], effort[i] * hold_[i]);
    if (std::abs(effort[i]) * share > room) share = room / std::abs(effort[i]);
  }
  const auto cap = [&](double load, double most) {
    if (load * share > most) share = most / load;
  };
  cap(force, force_cap);
  cap(moment, moment_cap);
  cap(on.delta.norm(), laparoscope_stage_force);
  cap(on.gimbal.norm(), laparoscope_stage_force);
  share = std::max(0.0, share);
  for (int i = 0; i < 6; ++i) {
    const bool same_sign = effort[i] * rendered_[i] > 0.0;
    const double reachable =
        (same_sign ? std::abs(rendered_[i]) : 0.0) + limits_.rise[i] * settings_.period;
    if (std::abs(effort[i]) * share > reachable) share = reachable / std::abs(effort[i]);
  }
  return share;
}

void StraightLaparoscope::send() RT_SAFE {
  for (int i = 0; i < 6; ++i) {
    rendered_[i] = scale * effort[i];
    effort_sent[i] = std::clamp(hold_[i] + rendered_[i], -limits_.effort[i], limits_.effort[i]);
  }
  const std::int64_t period = in_ns(settings_.period);
  receiver_.send(tick_, joints(effort_sent), (tick_ + deadline_periods) * period);
  receiver_.begin(tick_);
  plant_.apply(receiver_.effort().head<6>());
}

}  // namespace trocar::bench
