// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/command_report.hpp"

#include <QTest>

#include "tests/support/allocation_counter.hpp"

using namespace trocar::hid;

namespace {

CommandReport render() {
  CommandReport c;
  c.mode = CommandMode::render;
  c.acknowledge = true;
  c.sequence = 65535;
  c.tick = 0xFFFFFFFE;
  c.deadline_us = 0x80000001;
  c.hold = {-32767, 32767, 0, 1, -1, 100};
  c.effort = {32767, -32767, 0, -1, 1, -32000};
  return c;
}

}  // namespace

class TestCommandReport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void what_was_encoded_is_decoded_data() {
    QTest::addColumn<int>("mode");
    for (int mode = 0; mode < 4; ++mode) QTest::newRow(qPrintable(QString::number(mode))) << mode;
  }
  void what_was_encoded_is_decoded() {
    QFETCH(int, mode);
    CommandReport command = render(), back;
    command.mode = static_cast<CommandMode>(mode);
    Report report;
    encode(command, report);
    QCOMPARE(decode(report, back), ReportDefect::none);
    QVERIFY(back == command);
  }

  void beyond_the_peak_is_malformed_data() {
    QTest::addColumn<int>("hold");
    QTest::addColumn<int>("effort");
    QTest::addColumn<bool>("good");
    QTest::newRow("peak") << 32767 << 0 << true;
    QTest::newRow("peak by both") << 32000 << 767 << true;
    QTest::newRow("negative peak by both") << -32000 << -767 << true;
    QTest::newRow("one more") << 32000 << 768 << false;
    QTest::newRow("one less") << -32000 << -768 << false;
    QTest::newRow("hold -32768") << -32768 << 0 << false;
    QTest::newRow("effort -32768") << 0 << -32768 << false;
    QTest::newRow("-32768 and back") << -32768 << 1 << false;
    QTest::newRow("twice the peak") << 32767 << 32767 << false;
  }
  void beyond_the_peak_is_malformed() {
    QFETCH(int, hold);
    QFETCH(int, effort);
    QFETCH(bool, good);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      CommandReport command, back = render();
      command.hold[axis] = static_cast<std::int16_t>(hold);
      command.effort[axis] = static_cast<std::int16_t>(effort);
      Report report;
      encode(command, report);
      QCOMPARE(decode(report, back), good ? ReportDefect::none : ReportDefect::malformed);
      QVERIFY(back == (good ? command : render()));
    }
  }

  void what_is_reserved_must_be_zero() {
    CommandReport back;
    Report report;
    for (std::size_t at = 36; at < 60; ++at) {
      encode(render(), report);
      report[at] = 1;
      seal(report);
      QCOMPARE(decode(report, back), ReportDefect::malformed);
    }
    for (int bit = 2; bit < 7; ++bit) {
      encode(render(), report);
      report[1] = static_cast<std::uint8_t>(report[1] | 1 << bit);
      seal(report);
      QCOMPARE(decode(report, back), ReportDefect::malformed);
    }
  }

  void allocates_nothing() {
    Report report;
    CommandReport c = render();
    QCOMPARE(trocar::test::allocations_in([&] {
               encode(c, report);
               decode(report, c);
             }),
             0);
  }
};

QTEST_APPLESS_MAIN(TestCommandReport)
#include "tst_command_report.moc"
