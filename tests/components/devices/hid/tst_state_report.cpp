// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/state_report.hpp"

#include <QTest>

#include "tests/support/allocation_counter.hpp"

using namespace trocar::hid;

namespace {

StateReport engaged() {
  StateReport s;
  s.state = DeviceState::engaged;
  s.dead_man = true;
  s.sequence = 65535;
  s.time_us = 0xFFFFFFFF;
  s.encoder = {-155000, -8'388'608, encoder_max, 0, -1, 1};
  s.current = {-32768, 32767, 0, -1, 1, 1234};
  s.effort = {-32767, 32767, 0, -1, 1, 4321};
  s.temperature = {0, 255, 65, 66, 67, 68};
  s.last_command = 41;
  s.homed = all_homed;
  return s;
}

}  // namespace

class TestStateReport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void what_was_encoded_is_decoded() {
    Report report;
    StateReport back;
    encode(engaged(), report);
    QCOMPARE(decode(report, back), ReportDefect::none);
    QVERIFY(back == engaged());
  }

  void states_that_contradict_themselves_are_malformed_data() {
    QTest::addColumn<int>("state");
    QTest::addColumn<bool>("dead_man");
    QTest::addColumn<int>("homed");
    QTest::addColumn<int>("fault");
    QTest::addColumn<bool>("good");
    QTest::newRow("cold") << 0 << false << 0 << 0 << true;
    QTest::newRow("homing, two axes done") << 1 << false << 3 << 0 << true;
    QTest::newRow("ready") << 2 << false << 63 << 0 << true;
    QTest::newRow("engaged") << 3 << true << 63 << 0 << true;
    QTest::newRow("fault") << 4 << false << 0 << 1 << true;
    QTest::newRow("last fault") << 4 << false << 0 << 5 << true;
    QTest::newRow("ready, an axis not homed") << 2 << false << 31 << 0 << false;
    QTest::newRow("engaged, an axis not homed") << 3 << true << 62 << 0 << false;
    QTest::newRow("engaged without dead-man") << 3 << false << 63 << 0 << false;
    QTest::newRow("fault without cause") << 4 << true << 63 << 0 << false;
    QTest::newRow("cause without fault") << 2 << true << 63 << 2 << false;
    QTest::newRow("a seventh axis") << 2 << true << 127 << 0 << false;
    QTest::newRow("a state unknown") << 5 << true << 63 << 1 << false;
    QTest::newRow("a fault unknown") << 4 << true << 63 << 6 << false;
  }
  void states_that_contradict_themselves_are_malformed() {
    QFETCH(int, state);
    QFETCH(bool, dead_man);
    QFETCH(int, homed);
    QFETCH(int, fault);
    QFETCH(bool, good);
    StateReport s;
    s.state = static_cast<DeviceState>(state);
    s.dead_man = dead_man;
    s.homed = static_cast<std::uint8_t>(homed);
    s.fault = static_cast<DeviceFault>(fault);
    Report report;
    encode(s, report);
    StateReport back = engaged();
    QCOMPARE(decode(report, back), good ? ReportDefect::none : ReportDefect::malformed);
    QVERIFY(back == (good ? s : engaged()));  // what is refused changes nothing
  }

  void unknown_flags_are_malformed() {
    Report report;
    StateReport back;
    for (int bit = 4; bit < 8; ++bit) {
      encode(engaged(), report);
      report[1] = static_cast<std::uint8_t>(report[1] | 1 << bit);
      seal(report);
      QCOMPARE(decode(report, back), ReportDefect::malformed);
    }
  }

  void allocates_nothing() {
    Report report;
    StateReport s = engaged();
    QCOMPARE(trocar::test::allocations_in([&] {
               encode(s, report);
               decode(report, s);
             }),
             0);
  }
};

QTEST_APPLESS_MAIN(TestStateReport)
#include "tst_state_report.moc"
