// SPDX-License-Identifier: Apache-2.0
#include "components/devices/simulated_laparoscope.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace trocar {
namespace {

constexpr std::int64_t longest_gap_ns = 1'000'000'000;  // so that a tick stays bounded
constexpr double calm_force = 1.0;                      // [N] at the handle, to engage
constexpr double calm_moment = 0.1;                     // [N m]

Joints joints(const Vector6d& numbers) RT_SAFE {
  Joints result;
  result.head<6>() = numbers;
  return result;
}

void require_inside(const LaparoscopeLimits& limits, const LaparoscopeConfiguration& at) {
  const LimitSet violated = violated_limits(limits, at);
  std::string names;
  for (unsigned limit = 0; limit < LimitSet::count; ++limit)
    if (violated.has(limit))
      names += std::string(names.empty() ? "" : ", ") + LimitSet::name(limit);
  if (!names.empty())
    throw std::invalid_argument("start_position and start_angles violate " + names +
                                "; start inside the workspace, e.g. at {0, 0, \"85 mm\"}");
}

}  // namespace

SimulatedLaparoscope::SimulatedLaparoscope() {
  declare_device(device_position, hold, effort, effort_sent, scale);
}

LaparoscopePlantSettings SimulatedLaparoscope::plant_settings(const Setup& setup) const {
  LaparoscopePlantSettings settings;
  settings.geometry = geometry.value();
  settings.masses = imperfections.masses(masses.value(), *use.ideal);
  settings.limits = ranges.value();
  settings.hand = hand.value(static_cast<HandMode>(use.hand->index));
  settings.imperfections = imperfections.value(*use.ideal);
  settings.gravity = mount.gravity();
  settings.start = {start_position->eigen(), start_angles->x, start_angles->y, start_angles->z};
  settings.seed = setup.seed;
  return settings;
}

void SimulatedLaparoscope::configure(const Setup& setup) {
  const LaparoscopePlantSettings settings = plant_settings(setup);
  validate(settings.limits, settings.geometry);
  plant_.emplace(settings);
  require_inside(settings.limits, plant_->configuration());
  loads_.emplace(settings.geometry, *sites.handle_offset);
  limits_ = laparoscope_device_limits(settings.limits, setup.period);
  period_ns_ = std::llround(setup.period * 1e9);
  receiver_.emplace(period_ns_, static_cast<int>(*delay));
  weight_model_.emplace(geometry.value(), masses.value());
  gravity_ = mount.gravity();
  if (const auto s = own_weight(plant_->measured_position(), weight_); s != AssemblyStatus::ok)
    throw std::invalid_argument(std::string("the starting pose is reported as one that cannot be "
                                            "assembled: ") +
                                describe(s) + "; start inside the workspace");
  braked_ = !starts_engaged();
  const double slider = settings.drive.slider.resolution, ring = settings.drive.ring.resolution;
  if (settings.imperfections.position_quantisation)
    device_position.quality.resolution = {slider, slider, slider, ring, ring, ring};
}

AssemblyStatus SimulatedLaparoscope::own_weight(const Vector6d& position,
                                                Vector6d& holding) const RT_SAFE {
  const LaparoscopeModel& model = plant_->dynamics().model();
  LaparoscopeConfiguration c;
  const AssemblyStatus status = model.forward(position, c);
  if (status == AssemblyStatus::ok) holding = weight_model_->effort(c, model.rates(c), gravity_);
  return status;
}

/// Where the position cannot be assembled status() says so, and nothing is held.
Joints SimulatedLaparoscope::weight() const RT_SAFE {
  Vector6d holding = Vector6d::Zero();
  own_weight(device_position->head<6>(), holding);
  return joints(holding);
}

void SimulatedLaparoscope::start() {
  period_ = -1;
  report(0.0);
}

void SimulatedLaparoscope::step(const Tick& tick) RT_SAFE {
  const std::int64_t period = tick.time_ns / period_ns_;
  if (period_ < 0) {
    receiver_->start(period, braked_ ? Joints{} : joints(weight_));
    period_ = period;
    return;
  }
  const std::int64_t gone = period - period_;
  for (std::int64_t p = std::max(period_, period - longest_gap_ns / period_ns_); p < period; ++p)
    pass(p);
  period_ = period;
  report(static_cast<double>(gone * period_ns_) * 1e-9);
}

void SimulatedLaparoscope::pass(std::int64_t period) RT_SAFE {
  receiver_->begin(period);
  const std::int64_t acting = receiver_->acts_for(period);
  plant_->apply(receiver_->effort().head<6>());
  if (braked_ && !(acting > 0 && brake_lets_go())) return;
  plant_->load(external_wrench());
  move(acting);
  if (acting == period_ns_) return;
  plant_->apply(Vector6d::Zero());
  *effort_applied = {};
  move(period_ns_ - acting);
}

void SimulatedLaparoscope::move(std::int64_t duration_ns) RT_SAFE {
  if (duration_ns <= 0) return;
  const double duration = static_cast<double>(duration_ns) * 1e-9;
  plant_->advance(duration,
                  std::max(4, static_cast<int>(std::ceil(duration / *physics_step - 1e-6))));
}

bool SimulatedLaparoscope::brake_lets_go() RT_SAFE {
  const Vector6d missing = (plant_->sent_effort() - weight_).cwiseAbs();
  for (int i = 0; i < 6; ++i)
    if (!(missing[i] <= 0.01 * std::abs(weight_[i]) + (i < 3 ? 0.02 : 2e-3))) return false;
  braked_ = false;
  return true;
}

Vector6d SimulatedLaparoscope::external_wrench() const RT_SAFE {
  const Tool::State& tool = plant_->configuration().tool;
  Vector6d total = Vector6d::Zero();
  const auto add = [&](double s, const Inputs<Vector3>& loads) {
    Vector6d there = Vector6d::Zero();
    there.head<3>() = sum(loads);
    total += wrench_at_tip(tool, point_on_tool(tool, s), there);
  };
  add(*sites.tip_offset, tip_load);
  add(*sites.incision_offset, incision_load);
  add(*sites.handle_offset, handle_load);
  return total;
}

void SimulatedLaparoscope::report(double since_last) RT_SAFE {
  device_position->head<6>() = plant_->measured_position();
  reported_ = loads_->update(device_position->head<6>());
  const LaparoscopeConfiguration& c = plant_->configuration();
  const Eigen::Vector3d before = truth_tip->velocity.eigen();
  const Eigen::Vector3d moving =
      plant_->dynamics().model().rates(c).jacobian.topRows<3>() * plant_->velocity();
  truth_position->head<6>() = plant_->position();
  truth_velocity->head<6>() = plant_->velocity();
  *truth_tip = {c.tool.tip, moving};
  const SimulatedHand& grip = plant_->hand();
  if (!grip.present()) return;
  const HandSettings& h = grip.settings();
  Eigen::Vector3d force = grip.spring_wrench(c.tool, plant_->time()).head<3>();
  force += h.damping * (grip.target_velocity(plant_->time()) - moving);
  if (since_last > 0.0) force -= h.mass * (moving - before) / since_last;
  *truth_hand_force = force;
}

void SimulatedLaparoscope::write(const Tick& tick, const GatedEffort& gated) RT_SAFE {
  const std::int64_t period = tick.time_ns / period_ns_;
  receiver_->send(period, gated.effort(), gated.deadline_ns());
  receiver_->begin(period);
  plant_->apply(receiver_->effort().head<6>());
  effort_applied->head<6>() = plant_->sent_effort();
}

DeviceStatus SimulatedLaparoscope::status() const RT_SAFE {
  const AssemblyStatus status =
      plant_->status() == AssemblyStatus::ok ? reported_ : plant_->status();
  return {.position_valid = status == AssemblyStatus::ok, .why = describe(status)};
}

void SimulatedLaparoscope::tool_loads(const Joints& rendered, ToolLoads& loads) const RT_SAFE {
  const LaparoscopeLoads::Loads on = loads_->of(rendered.head<6>());
  const double force_cap = *handle_force_cap;
  const double moment_cap = *handle_moment_cap;
  loads.add({"handle force", on.handle_force, force_cap, 2.0 * force_cap, calm_force});
  loads.add({"handle moment", on.handle_moment, moment_cap, 2.0 * moment_cap, calm_moment});
  loads.add({.what = "delta stage", .value = on.delta, .cap = laparoscope_stage_force});
  loads.add({.what = "gimbal stage", .value = on.gimbal, .cap = laparoscope_stage_force});
}

double SimulatedLaparoscope::handle_speed(const Joints& velocity) const RT_SAFE {
  return loads_->handle_speed(velocity.head<6>());
}

}  // namespace trocar
