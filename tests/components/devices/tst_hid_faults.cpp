// SPDX-License-Identifier: Apache-2.0
// What goes wrong between driver and device, while it renders: named, latched, and at zero in time.
#include "components/devices/hid_laparoscope.hpp"

// Before Qt, whose macros take words that the framework uses.
#include "tests/support/hid_rig.hpp"

#include <QTest>

using namespace trocar;
using namespace trocar::test;
using hid::DeviceState;
using Emulated = EmulatedBench::Unit;

namespace {

struct EngagedRig : HidRig {
  EngagedRig() : HidRig(), unit(add_device(held())) {
    add_group();
    start();
    engage();
    if (gate().state() != Gate::State::engaged) qFatal("it does not render");
  }
  static hid::EmulatedLaparoscopeSettings held() {
    hid::EmulatedLaparoscopeSettings settings = EmulatedBench::settings(1);
    settings.plant.hand.mode = HandMode::firm;
    return settings;
  }
  /// Rendering by all the rules, with the loop as it is.
  bool renders_again() {
    ask(Command::Kind::engage);
    run(2200);
    return gate().state() == Gate::State::engaged &&
           unit.device.machine().state() == DeviceState::engaged;
  }
  Emulated& unit;
};

void break_it(EngagedRig& rig, const QString& what) {
  Emulated& unit = rig.unit;
  if (what == "silence") unit.faults.orders.loss = 1.0;
  if (what == "corruption") unit.faults.orders.corruption = 1.0;
  if (what == "stuck") unit.faults.orders.stuck = true;
  if (what == "delay") unit.faults.orders.delay_us = 9000;
  if (what == "encoder jump") unit.device.jump(1, 40'000);
  if (what == "heat") unit.device.heat(130.0);
  if (what == "deaf") unit.deaf = true;
  if (what == "unplug") rig.bench.unplug(unit);
}

void mend(EngagedRig& rig) {
  Emulated& unit = rig.unit;
  unit.faults.orders = {};
  unit.device.heat(30.0);
  unit.deaf = false;
  if (!unit.plugged) rig.bench.plug(unit);
}

}  // namespace

class TestHidFaults : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_fault_is_named_latched_and_over_in_time_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("named");
    QTest::addColumn<bool>("holds");  // the position is trusted
    QTest::addColumn<bool>("unhomed");
    const auto row = [](const char* name, const char* what, const char* named, bool holds,
                        bool unhomed) {
      QTest::newRow(name) << QString(what) << QString(named) << holds << unhomed;
    };
    row("reports stop", "silence", "position lost: no reports", false, false);
    row("reports are corrupted", "corruption", "position lost: reports corrupted", false, false);
    row("a report is stuck", "stuck", "position lost: reports repeated", false, false);
    row("reports come late", "delay", "position lost: no reports", false, false);
    row("an encoder jumps", "encoder jump", "device fault: encoder jump in the device", false,
        true);
    row("a motor is too hot", "heat", "device fault: temperature of a motor", true, false);
    row("commands do not arrive", "deaf", "device fault: watchdog of the device", false, false);
    row("the plug is pulled", "unplug", "position lost: unplugged", false, true);
  }
  void a_fault_is_named_latched_and_over_in_time() {
    QFETCH(QString, what);
    QFETCH(QString, named);
    QFETCH(bool, holds);
    QFETCH(bool, unhomed);
    EngagedRig rig;
    const std::int64_t before_ns = rig.unit.last_sent_ns;
    break_it(rig, what);
    rig.run(50);
    QCOMPARE(QString::fromStdString(rig.first_fault()), named);
    QCOMPARE(rig.gate().state(), Gate::State::tripped);
    QCOMPARE(*rig.device().scale, 0.0);
    QCOMPARE(rig.unit.silent_ns == 0, holds);
    if (!holds) {
      qInfo("zero %.2f ms after the last good report",
            1e-6 * static_cast<double>(rig.unit.silent_ns - before_ns));
      QVERIFY(rig.unit.silent_ns - before_ns <= 10'000'000);
    }
    rig.run(2000);
    QCOMPARE(rig.gate().state(), Gate::State::tripped);

    mend(rig);
    rig.run(300);
    if (unhomed) {
      rig.ask(Command::Kind::acknowledge);
      rig.run(1);
      QVERIFY2(rig.gate().state() == Gate::State::tripped, "it is not homed");
      rig.ask(Command::Kind::home);
      rig.run(700);
    }
    rig.ask(Command::Kind::acknowledge);
    rig.run(1500);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    QVERIFY(!rig.faults().latched());
    QVERIFY(!rig.unit.device.effort().isZero());
    QVERIFY(rig.renders_again());
  }

  void some_lost_and_damaged_reports_are_counted_and_borne() {
    EngagedRig rig;
    rig.unit.faults.orders = {.loss = 0.1, .corruption = 0.05};
    rig.run(1000);
    QCOMPARE(rig.gate().state(), Gate::State::engaged);
    const auto about = [](std::int64_t count, double expected) {
      return std::abs(static_cast<double>(count) - expected) < 5.0 * std::sqrt(expected);
    };
    const HidDevicePorts& told = rig.device().told;
    QVERIFY2(about(*told.reports_lost, 1000 * (0.1 + 0.9 * 0.05)),
             "one that is damaged never came either");
    QVERIFY(about(*told.reports_refused, 1000 * 0.9 * 0.05));
  }

  void what_comes_late_is_counted_and_not_used() {
    EngagedRig rig;
    rig.unit.faults.orders.delay_us = 9000;
    rig.run(100);
    QVERIFY(*rig.device().told.reports_refused >= 90);
    QVERIFY(*rig.device().told.report_age > 0.09);
  }

  void a_hung_loop_ends_in_the_devices_watchdog() {
    EngagedRig rig;
    rig.bench.advance_to(rig.bench.now() + 7'000'000);
    QVERIFY2(!rig.unit.device.effort().isZero(), "not yet");
    rig.bench.advance_to(rig.bench.now() + 3'000'000);
    QVERIFY(rig.unit.device.effort().isZero());
    QCOMPARE(rig.unit.device.machine().fault(), hid::DeviceFault::watchdog);
    rig.skip(10);
    rig.run(50);
    QCOMPARE(QString::fromStdString(rig.first_fault()),
             QString("device fault: watchdog of the device"));
    rig.run(200);
    rig.ask(Command::Kind::acknowledge);
    rig.run(1500);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    QVERIFY(rig.renders_again());
  }

  void what_returns_from_the_plug_is_refused_when_it_is_another_device() {
    EngagedRig rig;
    rig.bench.unplug(rig.unit);
    rig.run(10);
    hid::EmulatedLaparoscopeSettings other = EngagedRig::held();
    other.serial = 2;
    Emulated& stranger = rig.add_device(other);
    rig.run(300);
    QCOMPARE(*rig.device().told.connections, std::int64_t{1});
    QVERIFY(stranger.device.effort().isZero());
    stranger.plugged = false;
    rig.bench.plug(rig.unit);
    rig.run(300);
    QCOMPARE(*rig.device().told.connections, std::int64_t{2});
  }

  void nothing_is_rendered_by_a_report_of_before_the_unplugging() {
    EngagedRig rig;
    rig.bench.unplug(rig.unit);
    rig.run(200);
    rig.bench.plug(rig.unit);
    for (int i = 0; i < 500; ++i) {
      rig.run(1);
      QVERIFY(rig.unit.device.effort().isZero());
      QVERIFY(rig.device().effort_sent->head<6>().isZero());
    }
  }
};

QTEST_APPLESS_MAIN(TestHidFaults)
#include "tst_hid_faults.moc"
