// SPDX-License-Identifier: Apache-2.0
// What the gate asks of a device with states of its own, and makes of what that latched.
#include <QTest>
#include <string>

#include "tests/support/gate_rig.hpp"

using namespace trocar;
using trocar::test::GateRig;

namespace {

const char* const too_hot = "temperature";
const char* const no_command = "watchdog";

/// Cold, as hardware is.
struct ColdRig : GateRig {
  ColdRig() {
    device.engaged_at_start = false;
    device.report.renders = false;
    hold[0] = 5.0;
    gate();
  }
  DeviceMode mode() const { return device.written_mode; }
  void engage() {
    pass(1002);
    gate().request_engage();
    pass();
    device.report.renders = true;
    pass(1002);
  }
};

}  // namespace

class TestGateDevice : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_asks_for_what_it_sends() {
    ColdRig rig;
    rig.device.report.homed = false;
    rig.pass();
    QCOMPARE(rig.mode(), DeviceMode::off);
    rig.device.report.homed = true;
    rig.pass();
    QCOMPARE(rig.mode(), DeviceMode::hold);
    rig.pass(1000);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    QCOMPARE(rig.mode(), DeviceMode::hold);
    rig.gate().request_engage();
    rig.pass();
    QCOMPARE(rig.mode(), DeviceMode::render);
    rig.device.report.renders = true;
    rig.pass(1000);
    QCOMPARE(rig.gate().state(), Gate::State::engaged);
    QCOMPARE(rig.mode(), DeviceMode::render);
    rig.gate().stop_rendering({.cause = FaultCause::operator_stop});
    rig.pass();
    QCOMPARE(rig.mode(), DeviceMode::hold);
    rig.device.report.position_valid = false;
    rig.pass();
    QCOMPARE(rig.mode(), DeviceMode::off);
  }

  void it_says_what_of_the_effort_is_to_stay() {
    ColdRig rig;
    rig.effort[0] = 0.9;
    rig.engage();
    QCOMPARE(rig.sent(0), 5.9);
    QVERIFY(std::abs(rig.device.written_hold[0] - 5.0) < 1e-12);
    rig.gate().stop_rendering({.cause = FaultCause::operator_stop});
    rig.position[0] += 1e-4;
    rig.pass();
    QVERIFY2(rig.sent(0) < 4.99, "damped");
    QCOMPARE(rig.device.written_hold[0], rig.sent(0));
  }

  void it_renders_only_once_the_device_lets_effort_pass() {
    ColdRig rig;
    rig.effort[2] = 0.9;
    rig.gate().request_engage();
    rig.pass(4000);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    QCOMPARE(rig.sent(2), 0.0);
    rig.device.report.renders = true;
    rig.pass();
    QCOMPARE(rig.gate().state(), Gate::State::engaging);
  }

  void a_device_that_stops_rendering_ends_it_and_wants_a_new_request() {
    ColdRig rig;
    rig.effort[2] = 0.9;
    rig.engage();
    QCOMPARE(rig.gate().state(), Gate::State::engaged);
    rig.device.report.renders = false;
    rig.pass();
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    QCOMPARE(rig.sent(2), 0.0);
    QCOMPARE(rig.sent(0), 5.0);
    QVERIFY(!rig.faults.latched());
    QCOMPARE(rig.mode(), DeviceMode::hold);
  }

  void it_asks_anew_when_the_device_gave_up_before_the_gate_engaged() {
    ColdRig rig;
    rig.effort[2] = 1.5;  // not calm
    rig.pass(1002);
    rig.gate().request_engage();
    rig.device.report.renders = true;
    rig.pass(100);
    QCOMPARE(rig.mode(), DeviceMode::render);
    rig.device.report.renders = false;  // its dead-man was released
    rig.pass();
    QCOMPARE(rig.mode(), DeviceMode::hold);
  }

  void what_the_device_latched_ends_the_rendering_data() {
    QTest::addColumn<bool>("holds");
    QTest::addColumn<double>("sent");  // [N] of a hold of 5 N
    QTest::newRow("and it holds on") << true << 5.0;
    QTest::newRow("and it holds nothing") << false << 0.0;
  }
  void what_the_device_latched_ends_the_rendering() {
    QFETCH(bool, holds);
    QFETCH(double, sent);
    ColdRig rig;
    rig.effort[2] = 0.9;
    rig.engage();
    QCOMPARE(rig.sent(2), 0.9);
    rig.device.report.fault = holds ? too_hot : no_command;
    rig.device.report.holds = holds;
    rig.pass();
    QCOMPARE(rig.gate().state(), Gate::State::tripped);
    QCOMPARE(rig.faults.size(), std::size_t{1});
    QCOMPARE(rig.faults[0].cause, FaultCause::device_fault);
    QCOMPARE(std::string(rig.faults[0].detail), std::string(holds ? "temperature" : "watchdog"));
    QCOMPARE(rig.sent(2), 0.0);
    QCOMPARE(rig.sent(0), sent);
    QCOMPARE(rig.mode(), holds ? DeviceMode::hold : DeviceMode::off);
    rig.pass(500);
    QCOMPARE(rig.faults.raised(), std::size_t{1});
  }

  void acknowledging_clears_it_in_the_device() {
    ColdRig rig;
    rig.engage();
    rig.device.report.fault = no_command;
    rig.device.report.holds = false;
    rig.pass();
    QVERIFY2(!rig.gate().acknowledge(), "too early");
    rig.pass(150);
    QVERIFY(!rig.device.acknowledged);
    QVERIFY(rig.gate().acknowledge());
    rig.pass();
    QVERIFY(rig.device.acknowledged);
    QCOMPARE(rig.gate().state(), Gate::State::cold);
    rig.pass(3);
    QVERIFY2(rig.sent(0) == 0.0, "hold waits until the device is ready for it");
    rig.device.report = {.renders = false};
    rig.pass();
    QVERIFY(!rig.device.acknowledged);
    QVERIFY2(std::abs(rig.sent(0) - 0.005) < 1e-9, "and ramps up anew");
    rig.pass(2000);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    QCOMPARE(rig.mode(), DeviceMode::hold);
  }

  void what_the_device_does_not_clear_trips_again() {
    ColdRig rig;
    rig.engage();
    rig.device.report.fault = too_hot;
    rig.pass(150);
    QVERIFY(rig.gate().acknowledge());
    rig.faults.acknowledge();
    int asked = 0;
    bool before = false;
    for (int i = 0; i < 190; ++i) {
      rig.pass();
      asked += rig.device.acknowledged && !before ? 1 : 0;
      before = rig.device.acknowledged;
    }
    QVERIFY2(asked > 1, "it counts when it rises, and may come a moment too early");
    QVERIFY(!rig.faults.latched());
    rig.pass(20);
    QVERIFY(rig.faults.latched());
    QCOMPARE(rig.gate().state(), Gate::State::tripped);
    QVERIFY(!rig.device.acknowledged);
  }

  void homing_is_asked_for_until_it_is_done() {
    ColdRig rig;
    rig.device.report.homed = false;
    rig.pass();
    QVERIFY(rig.gate().request_home() == nullptr);
    rig.pass(50);
    QCOMPARE(rig.mode(), DeviceMode::home);
    QCOMPARE(rig.sent(0), 0.0);
    rig.device.report.homed = true;
    rig.pass();
    QCOMPARE(rig.mode(), DeviceMode::hold);
    QCOMPARE(std::string(rig.gate().request_home()), std::string("it is homed already"));
    QVERIFY(!rig.faults.latched());
  }

  void a_device_that_lost_its_homing_is_homed_and_then_acknowledged() {
    ColdRig rig;
    rig.engage();
    rig.device.report = {.why = "encoder jump",
                         .homed = false,
                         .renders = false,
                         .fault = "encoder jump",
                         .holds = false};
    rig.pass(200);
    QCOMPARE(rig.gate().state(), Gate::State::tripped);
    QVERIFY2(!rig.gate().acknowledge(), "its position still means nothing");
    QVERIFY(rig.gate().request_home() == nullptr);
    rig.pass();
    QCOMPARE(rig.mode(), DeviceMode::off);
    QVERIFY2(rig.device.acknowledged, "its own fault comes first");
    rig.device.report.fault = nullptr;
    rig.pass();
    QCOMPARE(rig.mode(), DeviceMode::home);
    rig.device.report = {.renders = false};
    rig.pass(150);
    QCOMPARE(rig.gate().state(), Gate::State::tripped);
    QCOMPARE(rig.mode(), DeviceMode::off);
    QVERIFY(rig.gate().acknowledge());
    rig.pass(1001);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    QCOMPARE(rig.sent(0), 5.0);
  }

  void what_ends_homing_data() {
    QTest::addColumn<QString>("what");
    for (const char* what : {"the operator", "no report", "a fault of its own"})
      QTest::newRow(what) << what;
  }
  void what_ends_homing() {
    QFETCH(QString, what);
    ColdRig rig;
    rig.device.report.homed = false;
    rig.pass();
    QVERIFY(rig.gate().request_home() == nullptr);
    rig.pass(5);
    if (what == "the operator") rig.gate().stop_rendering({.cause = FaultCause::operator_stop});
    if (what == "no report") rig.device.report.position_valid = false;
    if (what == "a fault of its own") rig.device.report.fault = "homing";
    rig.pass();
    QCOMPARE(rig.mode(), DeviceMode::off);
    QVERIFY(rig.faults.latched());
    rig.device.report = {.homed = false};
    rig.pass(10);
    QCOMPARE(rig.mode(), DeviceMode::off);
  }

  void without_a_report_nothing_is_homed() {
    ColdRig rig;
    rig.device.report = {.position_valid = false, .homed = false};
    rig.pass();
    QCOMPARE(std::string(rig.gate().request_home()),
             std::string("no report of the device is valid"));
  }
};

QTEST_GUILESS_MAIN(TestGateDevice)
#include "tst_gate_device.moc"
