// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/emulated_laparoscope.hpp"

#include <QTest>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "components/devices/hid/axis_scale.hpp"
#include "tests/support/allocation_counter.hpp"

using namespace trocar;
using namespace trocar::hid;

namespace {

/// A host of few words.
struct Bench {
  EmulatedLaparoscope device;
  CommandReport command;
  std::optional<StateReport> state;
  int states = 0;

  explicit Bench(const EmulatedLaparoscopeSettings& settings = {}) : device(settings) {}

  void ms(int count) {
    for (int i = 0; i < 4 * count; ++i) {
      if (i % 4 == 0) {
        ++command.sequence;
        command.deadline_us = device.time_us() + 3000;
        Report report;
        encode(command, report);
        device.receive(report);
      }
      device.cycle();
      Report report;
      while (device.next(report)) {
        StateReport told;
        if (decode(report, told) != ReportDefect::none) continue;
        state = told;
        ++states;
      }
    }
  }
  void home() {
    command.mode = CommandMode::home;
    ms(400);
  }
  void hold() {
    home();
    const AxisScale scale(device.pages().limits, device.pages().calibration);
    const LaparoscopeConfiguration& c = device.plant().configuration();
    const LaparoscopeGravity gravity({}, {});
    Joints weight;
    weight.head<6>() =
        gravity.effort(c, device.plant().dynamics().model().rates(c), standard_gravity);
    scale.put(weight, weight, command);
    command.mode = CommandMode::hold;
    ms(10);
  }
};

}  // namespace

class TestEmulatedLaparoscope : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_tells_its_state_once_a_period() {
    Bench bench;
    bench.ms(50);
    QCOMPARE(bench.states, 50);
    QCOMPARE(bench.state->state, DeviceState::unhomed);
    QCOMPARE(bench.state->homed, std::uint8_t{0});
    QCOMPARE(bench.state->temperature[0], std::uint8_t{65});
    QVERIFY2(bench.state->encoder == PerAxis<std::int32_t>{}, "its counts begin where it stands");
  }

  void homed_its_counts_are_where_the_axes_are() {
    Bench bench;
    bench.home();
    QCOMPARE(bench.state->state, DeviceState::ready);
    const AxisScale scale(bench.device.pages().limits, bench.device.pages().calibration);
    const Vector6d error =
        scale.position(bench.state->encoder).head<6>() - bench.device.plant().measured_position();
    QVERIFY(error.cwiseAbs().maxCoeff() < 1e-6);
  }

  void the_brake_opens_when_the_weight_is_held() {
    Bench bench;
    bench.home();
    bench.command.mode = CommandMode::hold;
    bench.ms(100);
    QVERIFY(bench.device.braked());
    QCOMPARE(bench.device.plant().time(), 0.0);
    bench.hold();
    QVERIFY(!bench.device.braked());
    const Vector6d before = bench.device.plant().position();
    bench.ms(500);
    QVERIFY((bench.device.plant().position() - before).norm() < 1e-3);
    bench.command.mode = CommandMode::off;
    bench.ms(100);
    QVERIFY2((bench.device.plant().position() - before).norm() > 1e-2, "and falls without it");
  }

  void it_answers_for_every_page() {
    EmulatedLaparoscope device({.serial = 42});
    for (const PageNumber page : {PageNumber::identity, PageNumber::geometry, PageNumber::range,
                                  PageNumber::limits, PageNumber::calibration}) {
      Report report;
      encode({page, 9}, report);
      device.receive(report);
      QVERIFY(device.next(report));
      PageRequest answered;
      QCOMPARE(decode_header(report, answered), ReportDefect::none);
      QCOMPARE(answered.page, page);
      QCOMPARE(answered.sequence, std::uint16_t{9});
      IdentityPage identity;
      if (page == PageNumber::identity) {
        QCOMPARE(decode(report, identity), ReportDefect::none);
        QCOMPARE(identity.serial, 42u);
        QCOMPARE(identity.period_us, std::uint16_t{1000});
      }
      QVERIFY(!device.next(report));
    }
  }

  void more_requests_than_it_keeps_are_lost() {
    EmulatedLaparoscope device;
    Report report;
    encode({PageNumber::limits, 1}, report);
    for (int i = 0; i < 100; ++i) device.receive(report);
    int answers = 0;
    while (device.next(report)) ++answers;
    QCOMPARE(answers, 8);
  }

  void a_jump_unhomes_and_heat_ends_the_rendering() {
    Bench bench;
    bench.hold();
    bench.device.heat(130.0);
    bench.ms(1);
    QCOMPARE(bench.state->fault, DeviceFault::temperature);
    QVERIFY(!bench.device.effort().isZero());
    bench.device.jump(2, -50'000);
    bench.ms(2);
    QCOMPARE(bench.state->homed, std::uint8_t{0});
    QVERIFY(bench.device.effort().isZero());
  }

  void without_power_it_forgets() {
    Bench bench;
    bench.hold();
    bench.device.power_cycle();
    bench.command = {};
    bench.ms(5);
    QCOMPARE(bench.state->state, DeviceState::unhomed);
    QVERIFY(bench.device.braked());
    QVERIFY(bench.state->time_us < 10'000);
  }

  void settings_that_no_device_can_have_are_refused() {
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, EmulatedLaparoscope({.cycle_us = 0}));
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, EmulatedLaparoscope({.cycle_us = 300}));
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, EmulatedLaparoscope({.period_us = 100'000}));
  }

  void a_cycle_does_not_allocate() {
    Bench bench;
    bench.hold();
    QCOMPARE(test::allocations_in([&] { bench.ms(100); }), 0);
  }
};

QTEST_APPLESS_MAIN(TestEmulatedLaparoscope)
#include "tst_emulated_laparoscope.moc"
