// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/hid_reports.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "components/devices/hid/axis_scale.hpp"
#include "components/devices/hid/device_state_machine.hpp"
#include "components/devices/hid/report_check.hpp"

namespace trocar::test {
namespace {

using namespace trocar::hid;

constexpr std::uint8_t sealed_from = 32, raw_from = 224;
constexpr std::size_t longest = 96;

#define PROMISE(condition)                                                 \
  do {                                                                     \
    if (!(condition)) {                                                    \
      std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                        \
    }                                                                      \
  } while (false)

bool same(const Report& report, ReportBytes bytes) {
  return bytes.size() == report_size && std::equal(report.begin(), report.end(), bytes.begin());
}

template <typename T>
void goes_there_and_back(ReportBytes bytes) {
  T value, untouched;
  Report again;
  if (decode(bytes, value) != ReportDefect::none) {
    PROMISE(value == untouched);
  } else {
    encode(value, again);
    PROMISE(same(again, bytes));
  }
}

template <typename Page>
void page_goes_there_and_back(ReportBytes bytes) {
  Page page, untouched;
  if (decode(bytes, page) != ReportDefect::none) {
    PROMISE(page == untouched);
    return;
  }
  PageRequest header;
  PROMISE(decode_header(bytes, header) == ReportDefect::none);
  Report again;
  encode(page, header.sequence, again);
  PROMISE(same(again, bytes));
}

void pages(ReportBytes bytes) {
  page_goes_there_and_back<IdentityPage>(bytes);
  page_goes_there_and_back<GeometryPage>(bytes);
  page_goes_there_and_back<RangePage>(bytes);
  page_goes_there_and_back<LimitsPage>(bytes);
  page_goes_there_and_back<CalibrationPage>(bytes);
  IdentityPage identity;
  if (decode(bytes, identity) == ReportDefect::none) PROMISE(identity.model_name().size() <= 24);
  LimitsPage limits;
  CalibrationPage calibration;
  if (decode(bytes, calibration) == ReportDefect::none) {
    limits.peak.fill(100);
    const Joints q =
        AxisScale(limits, calibration).position({encoder_max, -encoder_max, 0, 0, 1, 2});
    for (int i = 0; i < 6; ++i) PROMISE(std::isfinite(q[i]));
  }
}

PerAxis<double> each(double value) {
  return {value, value, value, value, value, value};
}

/// Host and device that live as long as one input.
struct Ends {
  ReportCheck check{{.speed = each(1e6), .oldest_ns = 3'000'000}};
  CommandIntake intake;
  DeviceStateMachine device{{.speed = each(1e6),
                             .calm_speed = each(1e4),
                             .calm_effort = each(164.0),
                             .homing_speed = each(1e4),
                             .homing_effort = {327, 327, 327, 491, 491, 491}}};
  DeviceInputs in;
  std::int64_t now_ns = 0;
  FuzzReach reach;

  void host(ReportBytes bytes) {
    const StateReport before = check.state();
    const ReportVerdict verdict = check.take(bytes, now_ns);
    ++(verdict == ReportVerdict::state  ? reach.states
       : verdict == ReportVerdict::page ? reach.pages
                                        : reach.refused_reports);
    if (verdict == ReportVerdict::state)
      PROMISE(bytes[0] == static_cast<std::uint8_t>(ReportKind::state));
    else
      PROMISE(check.state() == before);
  }

  void device_end(ReportBytes bytes) {
    const CommandReport before = intake.latest();
    const std::uint32_t taken = intake.taken();
    const bool refused = intake.take(bytes, in.time_us) != CommandRefusal::none;
    PROMISE(!refused || (intake.latest() == before && intake.taken() == taken));
    ++(refused ? reach.refused_commands : reach.commands);
    cycle();
    StateReport told;
    told.state = device.state();
    told.fault = device.fault();
    told.homed = device.homed();
    told.dead_man = in.dead_man;
    Report report;
    encode(told, report);
    PROMISE(decode(report, told) == ReportDefect::none);
  }

  void cycle() {
    const PerAxis<std::int16_t>& effort = device.step(in, intake);
    const bool still =
        device.state() == DeviceState::unhomed || !intake.watch(in.time_us) ||
        (device.state() != DeviceState::homing && intake.latest().mode == CommandMode::off);
    for (const std::int16_t one : effort) PROMISE(std::abs(int{one}) <= (still ? 0 : effort_max));
    PROMISE(device.state() != DeviceState::engaged || (in.dead_man && device.homed() == all_homed));
    PROMISE((device.state() == DeviceState::fault) == (device.fault() != DeviceFault::none));
    reach.device_states |= 1u << static_cast<unsigned>(device.state());
  }

  void wait(std::uint32_t elapsed_us) {
    in.time_us += elapsed_us;
    now_ns += 1000 * std::int64_t{elapsed_us};
  }

  /// The host goes on sending what it sent last, for half a second and a bit.
  void go_on() {
    for (int i = 0; i < 75; ++i) {
      wait(7000);
      CommandReport command = intake.latest();
      ++command.sequence;
      command.deadline_us = in.time_us;
      Report report;
      encode(command, report);
      intake.take(report, in.time_us);
      cycle();
    }
  }

  /// The prefix also moves time and the firmware's inputs, so that states are reached.
  void pass(std::uint8_t prefix) {
    in.dead_man = (prefix & 16) != 0;
    in.found = (prefix & 64) != 0 ? all_homed : 0;
    in.homing_effort.fill(static_cast<std::int16_t>(prefix * 100));
    if (prefix % 16 == 14)
      go_on();
    else
      wait(prefix % 16 == 15 ? 600'000 : 250u * (prefix % 16));
  }
};

void parse(ReportBytes bytes) {
  goes_there_and_back<StateReport>(bytes);
  goes_there_and_back<CommandReport>(bytes);
  goes_there_and_back<PageRequest>(bytes);
  pages(bytes);
}

}  // namespace

FuzzReach feed_hid_reports(std::span<const std::uint8_t> input) {
  Ends ends;
  while (!input.empty()) {
    const std::uint8_t prefix = input.front();
    input = input.subspan(1);
    const std::size_t size = std::min(input.size(), prefix < raw_from ? report_size : longest);
    ReportBytes bytes = input.first(size);
    Report whole{};
    if (prefix >= sealed_from && prefix < raw_from && size == report_size) {
      std::copy(bytes.begin(), bytes.end(), whole.begin());
      seal(whole);
      bytes = whole;
    }
    parse(bytes);
    ends.pass(prefix);
    ends.host(bytes);
    ends.device_end(bytes);
    input = input.subspan(size);
  }
  return ends.reach;
}

}  // namespace trocar::test
