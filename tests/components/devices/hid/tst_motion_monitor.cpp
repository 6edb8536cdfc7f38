// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/motion_monitor.hpp"

#include <QTest>

using namespace trocar::hid;

namespace {

constexpr PerAxis<double> speeds{1e6, 1e6, 1e6, 1e6, 1e6, 1e6};  // 1000 counts a ms

PerAxis<std::int32_t> all(std::int32_t count) {
  return {count, count, count, count, count, count};
}

}  // namespace

class TestMotionMonitor : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_jump_is_more_than_twice_the_speed_explains_data() {
    QTest::addColumn<int>("counts");
    QTest::addColumn<uint>("elapsed_us");
    QTest::addColumn<bool>("jump");
    QTest::newRow("nothing") << 0 << 1000u << false;
    QTest::newRow("as far as it may") << 2001 << 1000u << false;
    QTest::newRow("one more") << 2002 << 1000u << true;
    QTest::newRow("backwards") << -2002 << 1000u << true;
    QTest::newRow("a longer time explains it") << 2002 << 2000u << false;
    QTest::newRow("no time, one count of noise") << 1 << 0u << false;
    QTest::newRow("no time") << 2 << 0u << true;
  }
  void a_jump_is_more_than_twice_the_speed_explains() {
    QFETCH(int, counts);
    QFETCH(uint, elapsed_us);
    QFETCH(bool, jump);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      MotionMonitor monitor(speeds);
      monitor.update(all(-500), 0, 0);
      QVERIFY(!monitor.jumped());
      PerAxis<std::int32_t> next = all(-500);
      next[axis] += counts;
      monitor.update(next, elapsed_us, 0);
      QCOMPARE(monitor.jumped(), jump);
      monitor.update(next, 1000, 0);
      QVERIFY(!monitor.jumped());  // of the last update alone
      next[axis] += 1'000'000;
      monitor.update(next, 1000, static_cast<std::uint8_t>(1u << axis));
      QVERIFY(!monitor.jumped());  // set anew
    }
  }

  void speed_is_that_of_a_window_of_8_ms() {
    MotionMonitor monitor(speeds);
    monitor.update(all(0), 0, 0);
    for (int ms = 1; ms <= 8; ++ms) {
      QVERIFY(!monitor.too_fast());
      monitor.update(all(ms * 1001), 1000, 0);
    }
    QVERIFY(monitor.too_fast());
    QVERIFY(!monitor.faster_than({2e6, 2e6, 2e6, 2e6, 2e6, 2e6}));
    for (int ms = 1; ms <= 8; ++ms) monitor.update(all(8 * 1001), 1000, 0);
    QVERIFY(!monitor.faster_than({}));
  }

  void one_count_a_cycle_of_noise_is_no_speed() {
    MotionMonitor monitor(speeds);
    for (int i = 0; i < 320; ++i) {
      monitor.update(all(i % 2), 250, 0);
      QVERIFY(!monitor.faster_than({126, 126, 126, 126, 126, 126}));  // 1 count in 8 ms
    }
  }

  void a_count_set_anew_is_no_speed() {
    MotionMonitor monitor(speeds);
    monitor.update(all(0), 0, 0);
    for (int ms = 1; ms <= 4; ++ms) monitor.update(all(ms * 10), 1000, 0);
    monitor.update(all(900'000), 1000, 0x3F);
    for (int ms = 1; ms <= 3; ++ms) monitor.update(all(900'000 + ms * 10), 1000, 0);
    QVERIFY(monitor.faster_than({8000, 8000, 8000, 8000, 8000, 8000}));
    QVERIFY(!monitor.faster_than({9000, 9000, 9000, 9000, 9000, 9000}));
  }
};

QTEST_APPLESS_MAIN(TestMotionMonitor)
#include "tst_motion_monitor.moc"
