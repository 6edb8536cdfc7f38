// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/command_intake.hpp"

#include <QTest>
#include <vector>

using namespace trocar::hid;

namespace {

Report command(std::uint16_t sequence, std::uint32_t deadline_us) {
  CommandReport c;
  c.mode = CommandMode::hold;
  c.sequence = sequence;
  c.deadline_us = deadline_us;
  Report report;
  encode(c, report);
  return report;
}

}  // namespace

class TestCommandIntake : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_command_is_taken_once_and_in_order() {
    CommandIntake intake;
    QCOMPARE(intake.take(command(10, 3000), 0), CommandRefusal::none);
    QCOMPARE(intake.take(command(10, 3000), 500), CommandRefusal::repeated);
    QCOMPARE(intake.take(command(9, 3000), 600), CommandRefusal::reordered);
    QCOMPARE(intake.take(command(12, 4000), 1000), CommandRefusal::none);
    QCOMPARE(intake.take(command(11, 4000), 1001), CommandRefusal::reordered);
    QCOMPARE(intake.latest().sequence, std::uint16_t(12));
    QCOMPARE(intake.taken(), 2u);
    QCOMPARE(intake.count(CommandRefusal::repeated), 1u);
    QCOMPARE(intake.count(CommandRefusal::reordered), 2u);
  }

  void sequence_and_time_wrap() {
    CommandIntake intake;
    std::uint32_t now = 0xFFFFF000;
    std::uint16_t sequence = 65530;
    for (int i = 0; i < 20; ++i, now += 1000, ++sequence)
      QCOMPARE(intake.take(command(sequence, now + 3000), now), CommandRefusal::none);
    QCOMPARE(intake.take(command(65535, now + 3000), now), CommandRefusal::reordered);
  }

  void the_deadline_is_a_time_of_the_device_data() {
    QTest::addColumn<int>("left_us");
    QTest::addColumn<int>("expected");
    QTest::newRow("in time") << 3000 << int(CommandRefusal::none);
    QTest::newRow("at the last moment") << 0 << int(CommandRefusal::none);
    QTest::newRow("over") << -1 << int(CommandRefusal::late);
    QTest::newRow("long over") << -2'000'000'000 << int(CommandRefusal::late);
    QTest::newRow("as far as any loop's") << 20'000 << int(CommandRefusal::none);
    QTest::newRow("farther") << 20'001 << int(CommandRefusal::too_far);
  }
  void the_deadline_is_a_time_of_the_device() {
    QFETCH(int, left_us);
    QFETCH(int, expected);
    for (const std::uint32_t now : {5'000'000u, 0u, 0xFFFFFFFFu}) {
      CommandIntake intake;
      const auto deadline = now + static_cast<std::uint32_t>(left_us);
      QCOMPARE(int(intake.take(command(1, deadline), now)), expected);
      QCOMPARE(intake.watch(now), expected == 0);
    }
  }

  void the_watchdog_ends_it_8_ms_after_the_last_one() {
    for (const std::uint32_t start : {1000u, 0xFFFFFFFFu - 4000u}) {
      CommandIntake intake;
      QVERIFY(!intake.watch(start));
      intake.take(command(1, start + 3000), start);
      QVERIFY(intake.watch(start + 7999));
      QVERIFY(!intake.watch(start + 8000));
      QCOMPARE(intake.silences(), 1u);
      QVERIFY(!intake.watch(start + 100));  // not alive again by a wrap of the time
    }
  }

  void what_is_refused_does_not_feed_the_watchdog() {
    CommandIntake intake;
    intake.take(command(5, 3000), 0);
    Report bad = command(7, 9000);
    bad[20] ^= 1;
    QCOMPARE(intake.take(bad, 6000), CommandRefusal::corrupted);
    QCOMPARE(intake.take(command(5, 9000), 6000), CommandRefusal::repeated);
    QCOMPARE(intake.take(command(4, 9000), 6000), CommandRefusal::reordered);
    QCOMPARE(intake.take(command(6, 5000), 6000), CommandRefusal::late);
    QCOMPARE(intake.take(ReportBytes(bad).first(10), 6000), CommandRefusal::too_short);
    QCOMPARE(intake.take(std::vector<std::uint8_t>(65), 6000), CommandRefusal::too_long);
    Report other = command(7, 9000);
    other[0] = 0x11;
    seal(other);
    QCOMPARE(intake.take(other, 6000), CommandRefusal::foreign);
    other = command(7, 9000);
    other[40] = 1;
    seal(other);
    QCOMPARE(intake.take(other, 6000), CommandRefusal::malformed);
    QVERIFY(!intake.watch(8000));
    for (int refusal = 1; refusal < 9; ++refusal)
      QCOMPARE(intake.count(static_cast<CommandRefusal>(refusal)), 1u);
  }

  void a_host_that_starts_anew_begins_anywhere() {
    CommandIntake intake;
    intake.take(command(500, 3000), 0);
    QVERIFY(!intake.watch(10'000));
    QCOMPARE(intake.take(command(500, 12'000), 10'000), CommandRefusal::repeated);
    QCOMPARE(intake.take(command(3, 12'000), 10'000), CommandRefusal::none);
    QVERIFY(intake.watch(10'000));
    QCOMPARE(intake.silences(), 1u);
    QCOMPARE(intake.take(command(4, 30'000), 20'000), CommandRefusal::none);
    QCOMPARE(intake.silences(), 2u);  // though nobody watched in between
  }
};

QTEST_APPLESS_MAIN(TestCommandIntake)
#include "tst_command_intake.moc"
