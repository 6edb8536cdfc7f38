// SPDX-License-Identifier: Apache-2.0
#include "components/devices/command_receiver.hpp"

#include <QTest>

using namespace trocar;

namespace {

constexpr std::int64_t ms = 1'000'000;

Joints effort(double value) {
  Joints joints;
  joints[0] = value;
  return joints;
}

}  // namespace

class TestCommandReceiver : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_command_acts_its_delay_later_data() {
    QTest::addColumn<int>("delay");
    QTest::newRow("at once") << 0;
    QTest::newRow("one period") << 1;
    QTest::newRow("two periods") << 2;
  }
  void a_command_acts_its_delay_later() {
    QFETCH(int, delay);
    CommandReceiver receiver(ms, delay);
    receiver.start(100, effort(-1.0));
    for (std::int64_t k = 100; k < 130; ++k) {
      receiver.send(k, effort(static_cast<double>(k)), (k + 3) * ms);
      receiver.begin(k);
      QCOMPARE(receiver.effort()[0], k < 100 + delay ? -1.0 : static_cast<double>(k - delay));
      QCOMPARE(receiver.acts_for(k), ms);
    }
  }

  void a_part_of_a_period_is_kept_to_the_nanosecond_data() {
    QTest::addColumn<double>("delay");
    QTest::addColumn<int>("whole");
    QTest::addColumn<qint64>("part_ns");
    QTest::newRow("half a period") << 0.5 << 0 << qint64(500'000);
    QTest::newRow("one and a quarter") << 1.25 << 1 << qint64(250'000);
    QTest::newRow("a third") << 1.0 / 3.0 << 0 << qint64(333'333);
    QTest::newRow("nearly two") << 1.9999999999 << 2 << qint64(0);
  }
  void a_part_of_a_period_is_kept_to_the_nanosecond() {
    QFETCH(double, delay);
    QFETCH(int, whole);
    QFETCH(qint64, part_ns);
    CommandReceiver receiver(ms, delay);
    receiver.start(0, effort(-1.0));
    QCOMPARE(receiver.arrives_after(), part_ns);
    for (std::int64_t k = 0; k < 20; ++k) {
      receiver.send(k, effort(static_cast<double>(k)), (k + 3) * ms);
      receiver.begin(k);
      if (part_ns > 0) {
        QCOMPARE(receiver.effort()[0], k - 1 < whole ? -1.0 : static_cast<double>(k - 1 - whole));
        receiver.arrive(k);
      }
      QCOMPARE(receiver.effort()[0], k < whole ? -1.0 : static_cast<double>(k - whole));
    }
    // Nothing more is sent: 8 ms after the last arrival.
    QCOMPARE(receiver.acts_for(19 + 8), part_ns);
  }

  void the_watchdog_ends_it_8_ms_after_the_last_arrival_data() {
    QTest::addColumn<qint64>("period_ns");
    QTest::addColumn<int>("whole");       // periods in which it acts
    QTest::addColumn<qint64>("rest_ns");  // of the next
    QTest::newRow("1 kHz") << qint64(ms) << 8 << qint64(0);
    QTest::newRow("4 kHz") << qint64(ms / 4) << 32 << qint64(0);
    QTest::newRow("300 Hz: in the midst of a period")
        << qint64(3'333'333) << 2 << qint64(1'333'334);
    QTest::newRow("100 Hz: in the midst of every period") << qint64(10 * ms) << 0 << qint64(8 * ms);
  }
  void the_watchdog_ends_it_8_ms_after_the_last_arrival() {
    QFETCH(qint64, period_ns);
    QFETCH(int, whole);
    QFETCH(qint64, rest_ns);
    CommandReceiver receiver(period_ns, 1);
    receiver.start(0, {});
    receiver.send(0, effort(5.0), 3 * period_ns);
    receiver.begin(0);
    for (std::int64_t k = 1; k < 50; ++k) {
      receiver.begin(k);
      const std::int64_t since = k - 1;
      QCOMPARE(receiver.acts_for(k), since < whole ? period_ns : since == whole ? rest_ns : 0);
    }
  }

  void a_command_after_its_deadline_is_not_taken() {
    CommandReceiver receiver(ms, 2);
    receiver.start(0, effort(1.0));
    receiver.send(0, effort(2.0), 2 * ms - 1);
    receiver.begin(2);
    QCOMPARE(receiver.effort()[0], 1.0);
    receiver.send(1, effort(3.0), 3 * ms);
    receiver.begin(3);
    QCOMPARE(receiver.effort()[0], 3.0);
  }

  void nobody_resends_what_came_before_a_gap() {
    CommandReceiver receiver(ms, 1);
    receiver.start(0, effort(1.0));
    for (std::int64_t k = 0; k < 4; ++k) receiver.send(k, effort(2.0), (k + 3) * ms);
    for (std::int64_t k = 0; k < 40; ++k) receiver.begin(k);
    QCOMPARE(receiver.acts_for(40), std::int64_t(0));
  }
};

QTEST_APPLESS_MAIN(TestCommandReceiver)
#include "tst_command_receiver.moc"
