// SPDX-License-Identifier: Apache-2.0
// The driver with its whole graph against emulated devices, in virtual time.
#include "components/devices/hid_laparoscope.hpp"

// Before Qt, whose macros take words that the framework uses.
#include "tests/support/hid_rig.hpp"

#include <QTest>

#include "tests/support/allocation_counter.hpp"

using namespace trocar;
using namespace trocar::test;
using hid::DeviceState;
using Emulated = EmulatedBench::Unit;

namespace {

hid::EmulatedLaparoscopeSettings with_hand(HandMode mode, std::uint32_t serial = 1) {
  hid::EmulatedLaparoscopeSettings settings = EmulatedBench::settings(serial);
  settings.plant.hand.mode = mode;
  return settings;
}

}  // namespace

class TestHidLaparoscope : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void from_power_up_to_rendering() {
    HidRig rig;
    Emulated& unit = rig.add_device(with_hand(HandMode::firm));
    rig.add_group();
    rig.start();
    rig.run(100);
    QCOMPARE(rig.gate().state(), Gate::State::cold);
    QCOMPARE(unit.device.machine().state(), DeviceState::unhomed);
    QVERIFY(unit.device.effort().isZero());
    rig.ask(Command::Kind::home);
    rig.run(20);
    QCOMPARE(unit.device.machine().state(), DeviceState::homing);
    rig.run(380);
    QCOMPARE(unit.device.machine().state(), DeviceState::ready);
    const Vector6d error =
        rig.device().device_position->head<6>() - unit.device.plant().measured_position();
    QVERIFY(error.norm() < 1e-6);
    rig.run(1100);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    QVERIFY(!unit.device.braked());
    rig.run(1000);
    QVERIFY2(rig.gate().state() == Gate::State::holding, "nobody asked to render");
    rig.ask(Command::Kind::engage);
    rig.run(1200);
    QCOMPARE(rig.gate().state(), Gate::State::engaged);
    QCOMPARE(unit.device.machine().state(), DeviceState::engaged);
    QVERIFY2(!rig.faults().latched(), rig.first_fault().c_str());
    QCOMPARE(*rig.device().told.reports_lost, std::int64_t{0});
    QCOMPARE(*rig.device().told.reports_refused, std::int64_t{0});
  }

  // hand: F = k_h (x_h - z);  wall: F = K (z - surface), as on the simulated device
  void the_wall_stops_the_pushing_hand_where_statics_says() {
    HidRig rig(Settings{{"laparoscope_wall.damping", "20 N s/m"}});
    hid::EmulatedLaparoscopeSettings settings = with_hand(HandMode::pushes);
    settings.plant.imperfections = Imperfections::none();
    settings.plant.start.tip = {0.0, 0.0, 0.080};
    settings.plant.hand.push = {.depth = 0.060, .start = 2.5, .rise = 1.5, .dwell = 10.0};
    Emulated& unit = rig.add_device(settings);
    rig.add_group();
    rig.start();
    rig.engage();
    QCOMPARE(rig.gate().state(), Gate::State::engaged);
    rig.run(6000);
    QVERIFY2(!rig.faults().latched(), rig.first_fault().c_str());
    QCOMPARE(rig.gate().state(), Gate::State::engaged);
    const double expected = (250.0 * 0.140 + 2200.0 * 0.105) / (250.0 + 2200.0);
    const double rest = unit.device.plant().configuration().tool.tip.z();
    qInfo("rests at %.4f mm, statics says %.4f mm", 1e3 * rest, 1e3 * expected);
    QVERIFY2(std::abs(rest - expected) < 1e-5, "counts of encoders and efforts are that coarse");
  }

  void commands_arrive_in_time_and_reports_tell_what_acts() {
    HidRig rig;
    Emulated& unit = rig.add_device(with_hand(HandMode::firm));
    rig.add_group();
    rig.start();
    rig.engage();
    const hid::CommandIntake& intake = unit.device.intake();
    QCOMPARE(intake.count(hid::CommandRefusal::late), 0u);
    QCOMPARE(intake.count(hid::CommandRefusal::repeated), 0u);
    QCOMPARE(intake.silences(), 0u);
    QVERIFY(*rig.device().told.round_trip > 0.0 && *rig.device().told.round_trip < 3e-3);
    QVERIFY(*rig.device().told.report_age >= 0.0 && *rig.device().told.report_age <= 1e-3);
    const Vector6d applied = rig.device().effort_applied->head<6>();
    const Vector6d sent = rig.device().effort_sent->head<6>();
    QVERIFY((applied - sent).head<3>().cwiseAbs().maxCoeff() < 0.05);
    QVERIFY(sent.head<3>().cwiseAbs().maxCoeff() > 1.0);
  }

  void a_tick_does_not_allocate() {
    HidRig rig;
    rig.add_device(with_hand(HandMode::firm));
    rig.add_group();
    rig.start();
    rig.engage();
    QCOMPARE(allocations_in([&] { rig.run(1000); }), 0);
  }

  void two_runs_are_alike_to_the_bit() {
    const auto end = [] {
      HidRig rig;
      Emulated& unit = rig.add_device(with_hand(HandMode::pushes));
      rig.add_group();
      rig.start();
      rig.engage();
      return Vector6d(unit.device.plant().position());
    };
    QVERIFY(end() == end());
  }

  void releasing_the_dead_man_ends_the_rendering_until_asked_anew() {
    HidRig rig;
    Emulated& unit = rig.add_device(with_hand(HandMode::firm));
    rig.add_group();
    rig.start();
    rig.engage();
    unit.device.press_dead_man(false);
    rig.run(3);
    QCOMPARE(unit.device.machine().state(), DeviceState::ready);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    unit.device.press_dead_man(true);
    rig.run(2000);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    rig.ask(Command::Kind::engage);
    rig.run(1200);
    QCOMPARE(rig.gate().state(), Gate::State::engaged);
    QVERIFY2(!rig.faults().latched(), rig.first_fault().c_str());
  }

  void two_devices_are_told_apart_by_serial() {
    HidRig rig;
    Emulated& first = rig.add_device(with_hand(HandMode::firm, 11));
    Emulated& second = rig.add_device(with_hand(HandMode::firm, 22));
    rig.add_group("left", "22");
    rig.add_group("right", "11");
    rig.start();
    rig.ask(Command::Kind::home);
    rig.run(1600);
    QCOMPARE(rig.gate(0).state(), Gate::State::holding);
    QCOMPARE(rig.gate(1).state(), Gate::State::holding);
    rig.bench.unplug(second);
    rig.run(20);
    QCOMPARE(rig.gate(0).device().name(), std::string("left.device"));
    QCOMPARE(rig.gate(0).state(), Gate::State::tripped);
    QCOMPARE(rig.gate(1).state(), Gate::State::holding);
    QVERIFY(!first.device.effort().isZero());
    QVERIFY(second.device.effort().isZero());
    QCOMPARE(rig.first_fault(), std::string("position lost: unplugged"));
  }

  void when_the_run_ends_the_device_is_off_and_latches_nothing() {
    HidRig rig;
    Emulated& unit = rig.add_device(with_hand(HandMode::firm));
    rig.add_group();
    rig.start();
    rig.engage();
    rig.executor->stop({}, true);
    rig.bench.advance_to(rig.bench.now() + 20'000'000);
    QVERIFY(unit.device.effort().isZero());
    QCOMPARE(unit.device.machine().fault(), hid::DeviceFault::none);
    QCOMPARE(unit.device.machine().state(), DeviceState::ready);
  }
};

QTEST_APPLESS_MAIN(TestHidLaparoscope)
#include "tst_hid_laparoscope.moc"
