// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid_laparoscope.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "components/devices/hid/command_intake.hpp"
#include "components/devices/hid/device_line.hpp"

namespace trocar {
namespace {

constexpr double slowest_period = 4e-3;               // [s] half of the device's watchdog
constexpr std::int64_t settle_ns = 25'000'000;        // for estimators, after the position stepped
constexpr std::int64_t shortest_validity_us = 3'000;  // a way and a write, and once more
constexpr std::int64_t validity_periods = 3;

hid::CommandMode mode_of(DeviceMode mode) RT_SAFE {
  switch (mode) {
    case DeviceMode::off:
      return hid::CommandMode::off;
    case DeviceMode::hold:
      return hid::CommandMode::hold;
    case DeviceMode::render:
      return hid::CommandMode::render;
    case DeviceMode::home:
      return hid::CommandMode::home;
  }
  return hid::CommandMode::off;
}

/// With these the device goes on to hold its weight.
bool still_holds(hid::DeviceFault fault) RT_SAFE {
  return fault == hid::DeviceFault::none || fault == hid::DeviceFault::speed ||
         fault == hid::DeviceFault::temperature;
}

}  // namespace

HidLaparoscope::HidLaparoscope() {
  declare_device(device_position, hold, effort, effort_sent, scale);
}

HidLaparoscope::~HidLaparoscope() = default;

void HidLaparoscope::configure(const Setup& setup) {
  if (setup.period > slowest_period)
    throw std::invalid_argument("a rate of " + std::to_string(std::lround(1.0 / setup.period)) +
                                " Hz: the device's watchdog of 8 ms needs at least 250 Hz");
  which.source();  // the numbers are checked before the device is looked for
  validate(ranges.value(), geometry.value());
  period_ns_ = std::llround(setup.period * 1e9);
  model_.emplace(geometry.value());
  loads_.emplace(geometry.value(), *sites.handle_offset);
  weight_model_.emplace(geometry.value(), masses.value());
  gravity_ = mount.gravity();
  const AssemblyStatus status =
      model_->inverse({own.unhomed_position->eigen(), 0.0, 0.0, 0.0}, unhomed_position_);
  if (status != AssemblyStatus::ok)
    throw std::invalid_argument("unhomed_position = \"" + own.unhomed_position.text() +
                                "\": " + describe(status) + "; take a place inside the workspace");
  limits_ = laparoscope_device_limits(ranges.value(), setup.period);
  const double slider = *own.slider_resolution, ring = *own.ring_resolution;
  for (int i = 0; i < 6; ++i) {
    limits_.effort[i] = std::min(limits_.effort[i], i < 3 ? *own.slider_effort : *own.ring_effort);
    // Between two reports, each judged by the device's time when it came; this is between ticks.
    limits_.jump[i] += 2.0 * limits_.speed[i] * *own.report_stale;
  }
  device_position.quality.resolution = {slider, slider, slider, ring, ring, ring};
  device_position.quality.delay = 0.5 * setup.period;
  device_position->head<6>() = unhomed_position_;
}

std::unique_ptr<hid::DeviceLine> HidLaparoscope::line(const hid::DeviceLineSettings& settings) {
  static MonotonicTime time;  // has no state
  return std::make_unique<hid::DeviceLine>(which.source(), time, settings);
}

Pacer* HidLaparoscope::pacer() {
  return line_.get();
}

void HidLaparoscope::start() {
  const std::int64_t oldest_ns = std::llround(*own.report_stale * 1e9);
  line_ = line({.name = name(), .oldest_ns = oldest_ns, .period_ns = period_ns_});
  hid::ExpectedLaparoscope expected{
      .geometry = geometry.value(), .limits = limits_, .oldest_report_ns = oldest_ns};
  for (std::size_t i = 0; i < hid::axes; ++i)
    expected.resolution[i] = i < 3 ? *own.slider_resolution : *own.ring_resolution;
  try {
    const hid::LaparoscopePages& pages = line_->open();
    hid::require_agreement(pages, expected);
    scaling_.emplace(pages.limits, pages.calibration);
  } catch (const std::exception& error) {
    throw std::runtime_error(name() + ": " + error.what());
  }
  observe();
  line_->start();
}

void HidLaparoscope::stop() {
  if (line_ == nullptr) return;
  observe();
  line_->post(begin_command());  // off
  line_->stop();
}

void HidLaparoscope::step(const Tick&) RT_SAFE {
  observe();
}

void HidLaparoscope::observe() RT_SAFE {
  const hid::DeviceSnapshot& snapshot = line_->snapshot();
  begun_ns_ = line_->now();
  begun_device_us_ =
      static_cast<std::uint32_t>(snapshot.device_us + (begun_ns_ - snapshot.arrival_ns) / 1000);
  told.update(snapshot, begun_ns_);
  told.update(line_->written(), snapshot);
  take_position(snapshot);
  status_ = judge(snapshot);
}

void HidLaparoscope::take_position(const hid::DeviceSnapshot& snapshot) RT_SAFE {
  if (!snapshot.any) {
    homed_since_ns_ = 0;
    return;
  }
  *effort_applied = scaling_->effort(snapshot.state.effort);
  const bool homed = snapshot.state.homed == hid::all_homed && !snapshot.jumped;
  homed_since_ns_ = !homed ? 0 : homed_since_ns_ != 0 ? homed_since_ns_ : begun_ns_;
  if (homed)
    *device_position = scaling_->position(snapshot.state.encoder);
  else if (!snapshot.jumped)
    device_position->head<6>() = unhomed_position_;
  const Vector6d position = device_position->head<6>();
  assembled_ = loads_->update(position);
  LaparoscopeConfiguration c;
  if (model_->forward(position, c) == AssemblyStatus::ok)
    weight_.head<6>() = weight_model_->effort(c, model_->rates(c), gravity_);
}

DeviceStatus HidLaparoscope::judge(const hid::DeviceSnapshot& snapshot) const RT_SAFE {
  const hid::StateReport& state = snapshot.state;
  DeviceStatus status{.homed = false, .dead_man = false, .renders = false};
  const std::int64_t age_ns = snapshot.jumped
                                  ? begun_ns_ - snapshot.heard_ns
                                  : snapshot.under_way_ns + begun_ns_ - snapshot.arrival_ns;
  const bool heard = snapshot.any || snapshot.jumped;
  if (!snapshot.connected || !heard || !(static_cast<double>(age_ns) <= 1e9 * *own.report_stale)) {
    status.position_valid = false;
    status.why = *snapshot.trouble != 0 ? snapshot.trouble : "no reports";
    return status;
  }
  status.homed = homed_since_ns_ != 0 && begun_ns_ - homed_since_ns_ >= settle_ns;
  if (snapshot.jumped) {
    status.why = "encoder jump";
    return status;
  }
  status.dead_man = state.dead_man;
  status.renders = state.state == hid::DeviceState::engaged;
  status.fault = fault_name(state.fault);
  status.holds = still_holds(state.fault);
  if (assembled_ == AssemblyStatus::ok) return status;
  status.position_valid = false;
  status.why = describe(assembled_);
  return status;
}

/// By itself it asks for nothing.
hid::PostedCommand HidLaparoscope::begin_command() RT_SAFE {
  hid::PostedCommand posted{.number = ++posted_, .begun_ns = begun_ns_};
  const std::int64_t validity_us =
      std::clamp<std::int64_t>(validity_periods * period_ns_ / 1000, shortest_validity_us,
                               hid::CommandIntake::longest_validity_us);
  posted.command.deadline_us = begun_device_us_ + static_cast<std::uint32_t>(validity_us);
  return posted;
}

void HidLaparoscope::write(const Tick&, const GatedEffort& gated) RT_SAFE {
  hid::PostedCommand posted = begin_command();
  posted.command.mode = mode_of(gated.mode());
  posted.command.acknowledge = gated.acknowledges();
  posted.command.tick = static_cast<std::uint32_t>(gated.tick());
  scaling_->put(gated.hold(), gated.effort(), posted.command);
  line_->post(posted);
}

void HidLaparoscope::loop_stalled() {
  line_->loop_stalled();
}

void HidLaparoscope::tool_loads(const Joints& rendered, ToolLoads& loads) const RT_SAFE {
  caps.add(loads_->of(rendered.head<6>()), loads);
}

double HidLaparoscope::handle_speed(const Joints& velocity) const RT_SAFE {
  return loads_->handle_speed(velocity.head<6>());
}

}  // namespace trocar
