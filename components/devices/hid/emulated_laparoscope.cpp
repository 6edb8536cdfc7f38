// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/emulated_laparoscope.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "components/devices/laparoscope_device_limits.hpp"

namespace trocar::hid {
namespace {

constexpr double room = 25.0;               // [degC]
constexpr double as_the_plant = -300.0;     // [degC] colder than anything
constexpr std::uint32_t sense_us = 50'000;  // until the sensor of one axis more has told

const EmulatedLaparoscopeSettings& valid(const EmulatedLaparoscopeSettings& settings) {
  if (settings.cycle_us == 0 || settings.period_us % settings.cycle_us != 0 ||
      settings.period_us == 0 || settings.period_us > 0xFFFF)
    throw std::invalid_argument("period_us = " + std::to_string(settings.period_us) +
                                " and cycle_us = " + std::to_string(settings.cycle_us) +
                                ": a period is a whole number of cycles, and at most 65535 us");
  return settings;
}

LaparoscopePages pages_of(const EmulatedLaparoscopeSettings& settings) {
  const LaparoscopePlantSettings& plant = settings.plant;
  LaparoscopePages pages =
      laparoscope_pages(plant.geometry, laparoscope_device_limits(plant.limits, 1e-3), plant.drive);
  pages.identity.serial = settings.serial;
  pages.identity.period_us = static_cast<std::uint16_t>(settings.period_us);
  pages.identity.firmware = 0x0100;
  return pages;
}

}  // namespace

EmulatedLaparoscope::EmulatedLaparoscope(const EmulatedLaparoscopeSettings& settings)
    : settings_(valid(settings)),
      pages_(pages_of(settings)),
      plant_(settings.plant),
      weight_model_(settings.plant.geometry, settings.plant.masses),
      rules_(device_rules(pages_.limits, pages_.calibration, settings.plant.geometry.ring_radius)),
      machine_(rules_),
      celsius_(as_the_plant),
      time_us_(settings.power_up_us),
      sequence_(settings.first_sequence) {
  power_cycle();
  time_us_ = settings.power_up_us;
  sequence_ = settings.first_sequence;
}

/// Counts start at 0 where it stands; the clock starts somewhere else than it was.
void EmulatedLaparoscope::power_cycle() {
  machine_ = DeviceStateMachine(rules_);
  intake_ = CommandIntake();
  braked_ = true;
  time_us_ = settings_.power_up_us + 17;
  sequence_ = static_cast<std::uint16_t>(settings_.first_sequence + 7);
  since_report_us_ = homing_us_ = 0;
  waiting_ = 0;
  base_.fill(0);
  measure();
  for (std::size_t i = 0; i < axes; ++i) base_[i] = -encoder_[i];
}

void EmulatedLaparoscope::receive(ReportBytes bytes) RT_SAFE {
  PageRequest request;
  if (decode(bytes, request) == ReportDefect::none)
    answer(request);
  else
    intake_.take(bytes, time_us_);
}

Report* EmulatedLaparoscope::new_report() RT_SAFE {
  return waiting_ < outbox_.size() ? &outbox_[waiting_++] : nullptr;
}

void EmulatedLaparoscope::answer(const PageRequest& request) RT_SAFE {
  Report* report = new_report();
  if (report == nullptr) return;  // the host asks again
  switch (request.page) {
    case PageNumber::identity:
      return encode(pages_.identity, request.sequence, *report);
    case PageNumber::geometry:
      return encode(pages_.geometry, request.sequence, *report);
    case PageNumber::range:
      return encode(pages_.range, request.sequence, *report);
    case PageNumber::limits:
      return encode(pages_.limits, request.sequence, *report);
    case PageNumber::calibration:
      return encode(pages_.calibration, request.sequence, *report);
  }
}

void EmulatedLaparoscope::cycle() RT_SAFE {
  move();
  time_us_ += settings_.cycle_us;
  machine_.step(measure(), intake_);
  since_report_us_ += settings_.cycle_us;
  if (since_report_us_ < settings_.period_us) return;
  since_report_us_ = 0;
  report_state();
}

Vector6d EmulatedLaparoscope::effort() const RT_SAFE {
  Vector6d result;
  for (std::size_t i = 0; i < axes; ++i)
    result[static_cast<Eigen::Index>(i)] =
        machine_.effort()[i] * static_cast<double>(pages_.limits.peak[i]) / effort_max;
  return result;
}

void EmulatedLaparoscope::move() RT_SAFE {
  plant_.apply(effort());
  braked_ = braked_ && !brake_lets_go();
  if (braked_) return;
  const double duration = settings_.cycle_us * 1e-6;
  const double longest = std::min(plant_.longest_step(), 1e-4);
  plant_.advance(duration, std::max(1, static_cast<int>(std::ceil(duration / longest - 1e-6))));
}

bool EmulatedLaparoscope::brake_lets_go() const RT_SAFE {
  const LaparoscopeConfiguration& c = plant_.configuration();
  const Vector6d weight =
      weight_model_.effort(c, plant_.dynamics().model().rates(c), settings_.plant.gravity);
  const Vector6d missing = (plant_.sent_effort() - weight).cwiseAbs();
  for (int i = 0; i < 6; ++i)
    if (!(missing[i] <= 0.01 * std::abs(weight[i]) + (i < 3 ? 0.02 : 2e-3))) return false;
  return true;
}

DeviceInputs EmulatedLaparoscope::measure() RT_SAFE {
  DeviceInputs in;
  in.time_us = time_us_;
  in.dead_man = dead_man_;
  const bool homing = machine_.state() == DeviceState::homing;
  homing_us_ = homing ? homing_us_ + settings_.cycle_us : 0;
  const Vector6d position = plant_.measured_position();
  const Vector6d& rise = plant_.temperature().rise();
  for (std::size_t i = 0; i < axes; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (homing && homing_us_ >= (i + 1) * sense_us && (machine_.homed() >> i & 1u) == 0) {
      base_[i] = pages_.calibration.offset[i];
      in.found = static_cast<std::uint8_t>(in.found | 1u << i);
    }
    const auto sensed = static_cast<std::int32_t>(
        std::lround(position[axis] / static_cast<double>(pages_.calibration.unit[i])));
    encoder_[i] = std::clamp(sensed + base_[i], -encoder_max, encoder_max);
    const double celsius = celsius_ > as_the_plant ? celsius_ : room + rise[axis];
    temperature_[i] = static_cast<std::uint8_t>(std::clamp(celsius + temperature_zero, 0.0, 255.0));
  }
  in.encoder = encoder_;
  in.temperature = temperature_;
  return in;
}

void EmulatedLaparoscope::report_state() RT_SAFE {
  Report* report = new_report();
  if (report == nullptr) return;
  StateReport state{.state = machine_.state(),
                    .dead_man = dead_man_,
                    .sequence = ++sequence_,
                    .time_us = time_us_,
                    .encoder = encoder_,
                    .effort = machine_.effort(),
                    .temperature = temperature_,
                    .last_command = intake_.latest().sequence,
                    .homed = machine_.homed(),
                    .fault = machine_.fault()};
  for (std::size_t i = 0; i < axes; ++i)
    state.current[i] = static_cast<std::int16_t>(
        std::lround(state.effort[i] * (1e3 * settings_.peak_current / effort_max)));
  encode(state, *report);
}

bool EmulatedLaparoscope::next(Report& report) RT_SAFE {
  if (waiting_ == 0) return false;
  report = outbox_[0];
  std::copy(outbox_.begin() + 1, outbox_.begin() + static_cast<std::ptrdiff_t>(waiting_),
            outbox_.begin());
  --waiting_;
  return true;
}

}  // namespace trocar::hid
