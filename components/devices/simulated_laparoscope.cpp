// SPDX-License-Identifier: Apache-2.0
#include "components/devices/simulated_laparoscope.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace trocar {
namespace {

constexpr std::int64_t longest_gap_ns = 1'000'000'000;         // so that a tick stays bounded
constexpr std::uint64_t reports_stream = 0x5265706f72747321u;  // apart from the plant's draws

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

void require_fine(double step, double longest) {
  if (step <= longest) return;
  const Unit ms = parse_unit("ms");
  throw std::invalid_argument("physics_step = \"" + format_quantity(step, ms) + "\": at most " +
                              format_quantity(longest, ms) +
                              " for transmissions as stiff and motors as light as these");
}

}  // namespace

SimulatedLaparoscope::SimulatedLaparoscope() {
  declare_device(device_position, hold, effort, effort_sent, scale);
}

LaparoscopePlantSettings SimulatedLaparoscope::plant_settings(const Setup& setup) const {
  LaparoscopePlantSettings settings;
  settings.geometry = geometry.value();
  settings.masses = masses.value();
  if (*use.ideal) {
    settings.imperfections = Imperfections::none();
  } else {
    drives.apply(settings);
    mechanism.apply(settings);
  }
  settings.limits = ranges.value();
  settings.hand = hand.value(static_cast<HandMode>(use.hand->index));
  settings.gravity = mount.gravity();
  settings.start = {start_position->eigen(), start_angles->x, start_angles->y, start_angles->z};
  settings.seed = setup.seed;
  return settings;
}

void SimulatedLaparoscope::configure(const Setup& setup) {
  const LaparoscopePlantSettings settings = plant_settings(setup);
  validate(settings.limits, settings.geometry);
  plant_.emplace(settings);
  require_fine(*physics_step, plant_->longest_step());
  require_inside(settings.limits, plant_->configuration());
  loads_.emplace(settings.geometry, *sites.handle_offset);
  limits_ = laparoscope_device_limits(settings.limits, setup.period);
  period_ns_ = std::llround(setup.period * 1e9);
  receiver_.emplace(period_ns_, *link.delay);
  const ReportSettings reports = *use.ideal ? ReportSettings{} : link.reports(setup.period);
  reports_.emplace(reports, setup.seed ^ reports_stream);
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
  device_position.quality.delay = 0.5 * reports.jitter * setup.period;
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
  sampled_ = received_ = plant_->measured_position();
  received_at_ns_ = 0;
  *report_age = 0.0;
  report(0.0);
}

void SimulatedLaparoscope::step(const Tick& tick) RT_SAFE {
  const std::int64_t period = tick.time_ns / period_ns_;
  if (period_ < 0) {
    receiver_->start(period, braked_ ? Joints{} : joints(weight_));
    period_ = period;
    received_at_ns_ = period * period_ns_;
    return;
  }
  const std::int64_t gone = period - period_;
  for (std::int64_t p = std::max(period_, period - longest_gap_ns / period_ns_); p < period; ++p)
    pass(p);
  period_ = period;
  *report_age = static_cast<double>(period * period_ns_ - received_at_ns_) * 1e-9;
  report(static_cast<double>(gone * period_ns_) * 1e-9);
}

void SimulatedLaparoscope::pass(std::int64_t period) RT_SAFE {
  const ReportChannel::Report next = reports_->next();
  const std::int64_t sampled =
      period_ns_ - static_cast<std::int64_t>(next.early * static_cast<double>(period_ns_));
  receiver_->begin(period);
  plant_->apply(receiver_->effort().head<6>());
  if (!braked_ || (receiver_->acts_for(period) > 0 && brake_lets_go())) {
    plant_->load(external_wrench());
    move_through(period, sampled);
  }
  if (!next.arrives) return;
  received_ = sampled_;
  received_at_ns_ = period * period_ns_ + sampled;
}

/// From event to event of a period: a command arrives, the watchdog bites, the encoders are
/// sampled.
void SimulatedLaparoscope::move_through(std::int64_t period, std::int64_t sampled_ns) RT_SAFE {
  const std::int64_t arrives = receiver_->arrives_after();
  for (std::int64_t now = 0; now < period_ns_;) {
    if (now > 0 && now == arrives) receiver_->arrive(period);
    const std::int64_t ends = receiver_->acts_for(period);
    act(now < ends ? Vector6d(receiver_->effort().head<6>()) : Vector6d(Vector6d::Zero()));
    std::int64_t until = period_ns_;
    for (const std::int64_t event : {arrives, ends, sampled_ns})
      if (event > now && event < until) until = event;
    move(until - now);
    now = until;
    if (now == sampled_ns) sampled_ = plant_->measured_position();
  }
}

void SimulatedLaparoscope::act(const Vector6d& command) RT_SAFE {
  plant_->apply(command);
  effort_applied->head<6>() = plant_->sent_effort();
}

void SimulatedLaparoscope::move(std::int64_t duration_ns) RT_SAFE {
  const double duration = static_cast<double>(duration_ns) * 1e-9;
  const double period = static_cast<double>(period_ns_) * 1e-9;
  plant_->advance(duration,
                  std::max(1, static_cast<int>(std::ceil(
                                  duration / std::min(*physics_step, 0.25 * period) - 1e-6))));
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
  device_position->head<6>() = received_;
  reported_ = loads_->update(received_);
  report_truth(since_last);
}

void SimulatedLaparoscope::report_truth(double since_last) RT_SAFE {
  const LaparoscopeConfiguration& c = plant_->configuration();
  const Eigen::Vector3d before = truth.tip->velocity.eigen();
  const Eigen::Vector3d moving =
      plant_->dynamics().model().rates(c).jacobian.topRows<3>() * plant_->velocity();
  truth.position->head<6>() = plant_->position();
  truth.velocity->head<6>() = plant_->velocity();
  truth.motor_position->head<6>() = plant_->motor_position();
  truth.temperature->head<6>() = plant_->temperature().rise();
  truth.gain->head<6>() = plant_->gain();
  *truth.tip = {c.tool.tip, moving};
  const SimulatedHand& grip = plant_->hand();
  if (!grip.present()) return;
  const HandSettings& h = grip.settings();
  Eigen::Vector3d force = grip.spring_wrench(c.tool, plant_->time()).head<3>();
  force += h.damping * (grip.target_velocity(plant_->time()) - moving);
  if (since_last > 0.0) force -= h.mass * (moving - before) / since_last;
  *truth.hand_force = force;
}

void SimulatedLaparoscope::write(const Tick& tick, const GatedEffort& gated) RT_SAFE {
  const std::int64_t period = tick.time_ns / period_ns_;
  receiver_->send(period, gated.effort(), gated.deadline_ns());
  receiver_->begin(period);
  act(receiver_->effort().head<6>());
}

DeviceStatus SimulatedLaparoscope::status() const RT_SAFE {
  if (!(*report_age <= *link.report_stale)) return {.position_valid = false, .why = "reports lost"};
  const AssemblyStatus status =
      plant_->status() == AssemblyStatus::ok ? reported_ : plant_->status();
  return {.position_valid = status == AssemblyStatus::ok, .why = describe(status)};
}

void SimulatedLaparoscope::tool_loads(const Joints& rendered, ToolLoads& loads) const RT_SAFE {
  caps.add(loads_->of(rendered.head<6>()), loads);
}

double SimulatedLaparoscope::handle_speed(const Joints& velocity) const RT_SAFE {
  return loads_->handle_speed(velocity.head<6>());
}

}  // namespace trocar
