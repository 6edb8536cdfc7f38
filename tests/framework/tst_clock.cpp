// SPDX-License-Identifier: Apache-2.0
#include "framework/clock.hpp"

#include <random>
#include <stdexcept>

#include <QTest>

#include "tests/support/virtual_time.hpp"

using namespace trocar;
using test::VirtualTime;

namespace {

constexpr qint64 us = 1'000;      // [ns]
constexpr qint64 ms = 1'000'000;  // [ns]

void spend(std::int64_t nanoseconds) {
  const std::int64_t end = monotonic_ns() + nanoseconds;
  while (monotonic_ns() < end) {
  }
}

}  // namespace

class TestClock : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void virtual_time_uses_every_slot_and_starts_anew() {
    SimulatedClock clock;
    for (int run = 0; run < 2; ++run) {
      clock.start(ms);
      for (std::int64_t i = 0; i < 100; ++i) {
        const Slot slot = clock.wait();
        QCOMPARE(slot.index, i);
        QCOMPARE(slot.lateness_ns, std::int64_t{0});
        QCOMPARE(slot.skipped, std::int64_t{0});
      }
    }
    QVERIFY(clock.simulated());
    QVERIFY(!PeriodicClock().simulated());
  }

  void a_million_ticks_with_random_overruns_do_not_drift_data() {
    QTest::addColumn<qint64>("period");
    QTest::addColumn<qint64>("spin");
    QTest::newRow("1 kHz") << qint64{1'000'000} << qint64{0};
    QTest::newRow("3 kHz, which is no whole number of ns") << qint64{333'333} << qint64{0};
    QTest::newRow("10 kHz with a guard spin") << qint64{100'000} << qint64{2'000};
  }
  void a_million_ticks_with_random_overruns_do_not_drift() {
    QFETCH(qint64, period);
    QFETCH(qint64, spin);
    std::mt19937_64 random(3);
    std::exponential_distribution<double> share(1.0);
    const auto some = [&](double periods) {
      return static_cast<std::int64_t>(share(random) * periods * static_cast<double>(period));
    };
    VirtualTime time;
    const std::int64_t origin = time.now_ns = 1'234'567'891;
    time.look_ns = spin > 0 ? 100 : 0;
    time.wake_up = [&] { return some(0.05); };
    PeriodicClock clock(spin, time);
    clock.start(period);
    const std::int64_t start = origin + time.look_ns;
    std::int64_t used = 0, skipped = 0, overran = 0;
    for (int i = 0; i < 1'000'000; ++i) {
      const Slot slot = clock.wait();
      const std::int64_t begin = time.now_ns;
      ++used;
      skipped += slot.skipped;
      // Elapsed time over the period is slots used and skipped, to the nanosecond.
      QCOMPARE(slot.index, used + skipped - 1);
      QCOMPARE(begin - slot.lateness_ns, start + slot.index * period);
      QCOMPARE(slot.date_ns, begin);
      QVERIFY(slot.lateness_ns >= 0);
      time.spend(some(i % 100 == 0 ? 4.0 : 0.3));
      const std::int64_t late = time.now_ns + time.look_ns - (start + (slot.index + 1) * period);
      if (late > 0) ++overran;
    }
    QVERIFY(skipped > 10'000 && overran > skipped / 4);
  }

  void how_long_a_tick_went_on_is_told_with_the_next_slot_data() {
    QTest::addColumn<qint64>("spent");    // [ns] in the tick at slot 0
    QTest::addColumn<qint64>("skipped");  // what the next slot says
    QTest::addColumn<qint64>("overrun");
    QTest::addColumn<qint64>("lateness");
    QTest::newRow("a short one") << qint64{300 * us} << qint64{0} << qint64{0} << qint64{7 * us};
    QTest::newRow("until the very slot") << qint64{ms} << qint64{0} << qint64{0} << qint64{0};
    QTest::newRow("1 ns longer") << qint64{ms + 1} << qint64{0} << qint64{1} << qint64{1};
    QTest::newRow("within the slot") << 1900 * us << qint64{0} << 900 * us << 900 * us;
    QTest::newRow("until slot 2") << 2 * ms << qint64{1} << ms << qint64{0};
    QTest::newRow("five periods and a half") << 5500 * us << qint64{4} << 4500 * us << 500 * us;
  }
  void how_long_a_tick_went_on_is_told_with_the_next_slot() {
    QFETCH(qint64, spent);
    QFETCH(qint64, skipped);
    QFETCH(qint64, overrun);
    QFETCH(qint64, lateness);
    VirtualTime time;
    time.wake_up = [] { return 7 * us; };
    PeriodicClock clock(0, time);
    clock.start(ms);
    const Slot first = clock.wait();
    QCOMPARE(first.overrun_ns, std::int64_t{0});
    time.spend(spent);
    const Slot second = clock.wait();
    QCOMPARE(qint64{second.skipped}, skipped);
    QCOMPARE(qint64{second.overrun_ns}, overrun);
    QCOMPARE(qint64{second.lateness_ns}, lateness);
  }

  void the_guard_spin_takes_the_wake_up_out_of_the_lateness_data() {
    QTest::addColumn<qint64>("spin");
    QTest::addColumn<qint64>("wake_up");
    QTest::addColumn<qint64>("lateness");  // of each tick
    QTest::addColumn<qint64>("spun");      // for each tick; with an error of one look
    QTest::newRow("off") << qint64{0} << 60 * us << 60 * us << qint64{0};
    QTest::newRow("longer than the wake-up") << 100 * us << 60 * us << qint64{0} << 40 * us;
    QTest::newRow("shorter than the wake-up") << 40 * us << 60 * us << 20 * us << qint64{0};
    QTest::newRow("nearly the period") << 999 * us << 60 * us << qint64{0} << 900 * us;
  }
  void the_guard_spin_takes_the_wake_up_out_of_the_lateness() {
    QFETCH(qint64, spin);
    QFETCH(qint64, wake_up);
    QFETCH(qint64, lateness);
    QFETCH(qint64, spun);
    constexpr int ticks = 1000;
    VirtualTime time;
    time.look_ns = 20;
    time.wake_up = [=] { return wake_up; };
    PeriodicClock clock(spin, time);
    clock.start(ms);
    clock.wait();
    for (int i = 0; i < ticks; ++i) {
      time.spend(100 * us);
      const Slot slot = clock.wait();
      QVERIFY2(std::abs(slot.lateness_ns - lateness) <= 2 * time.look_ns,
               qPrintable(QString::number(slot.lateness_ns)));
      QCOMPARE(slot.skipped, std::int64_t{0});
    }
    const std::int64_t each = clock.spun_ns() / ticks;
    QVERIFY2(std::abs(each - spun) <= 60 * us * (spin == 999 * us) + 3 * time.look_ns,
             qPrintable(QString::number(each)));
    clock.start(ms);
    QCOMPARE(clock.spun_ns(), std::int64_t{0});
  }

  void a_guard_spin_is_shorter_than_the_period_data() {
    QTest::addColumn<qint64>("spin");
    QTest::addColumn<QString>("says");  // "" when it is possible
    QTest::newRow("none") << qint64{0} << "";
    QTest::newRow("a usual one") << 100 * us << "";
    QTest::newRow("all but a ns") << ms - 1 << "";
    QTest::newRow("the period") << qint64{ms} << "a guard spin of 1000 µs at a period of 1000 µs";
    QTest::newRow("longer") << 2 * ms << "shorter than the period";
    QTest::newRow("negative") << -us << "a guard spin of -1 µs";
  }
  void a_guard_spin_is_shorter_than_the_period() {
    QFETCH(qint64, spin);
    QFETCH(QString, says);
    QCOMPARE(check_spin(spin, ms).empty(), says.isEmpty());
    PeriodicClock clock(spin);
    try {
      clock.start(ms);
      QVERIFY(says.isEmpty());
    } catch (const std::invalid_argument& error) {
      QVERIFY2(!says.isEmpty() && QString(error.what()).contains(says), error.what());
    }
  }

  void a_guard_spin_on_the_machines_clock_is_never_early() {
    PeriodicClock clock(200 * us);
    clock.start(ms);
    std::int64_t used = 0, skipped = 0;
    for (int i = 0; i < 200; ++i) {
      const Slot slot = clock.wait();
      skipped += slot.skipped;
      QCOMPARE(slot.index, used++ + skipped);
      QVERIFY(slot.lateness_ns >= 0);
    }
    QVERIFY(clock.spun_ns() > 0);
  }

  void every_slot_is_used_or_counted_on_an_absolute_raster() {
    PeriodicClock clock;
    const std::int64_t before = monotonic_ns();
    clock.start(2 * ms);
    std::int64_t used = 0, skipped = 0;
    for (int i = 0; i < 100; ++i) {
      const Slot slot = clock.wait();
      const std::int64_t now = monotonic_ns();
      ++used;
      skipped += slot.skipped;
      QCOMPARE(slot.index, used + skipped - 1);
      QVERIFY(slot.lateness_ns >= 0);
      // The slot's own date, however late earlier ones were: no drift.
      QVERIFY(now - slot.lateness_ns >= before + slot.index * 2 * ms);
    }
  }

  void a_slot_that_is_over_is_skipped_and_never_made_up_for() {
    PeriodicClock clock;
    clock.start(10 * ms);
    QCOMPARE(clock.wait().index, std::int64_t{0});
    spend(35 * ms);  // slots 1 and 2 pass by; 3 has begun
    const Slot late = clock.wait();
    QVERIFY(late.skipped >= 2);
    QCOMPARE(late.index, late.skipped + 1);
    QVERIFY(late.lateness_ns >= 0);
    const Slot next = clock.wait();
    QVERIFY(next.index > late.index);
    QCOMPARE(next.index, late.index + next.skipped + 1);
  }

  void a_slot_that_still_lasts_is_used_late() {
    PeriodicClock clock;
    clock.start(500 * ms);
    QCOMPARE(clock.wait().index, std::int64_t{0});
    spend(520 * ms);
    const Slot slot = clock.wait();
    if (slot.skipped > 0) QSKIP("the machine stood still for half a second");
    QCOMPARE(slot.index, std::int64_t{1});
    QVERIFY(slot.lateness_ns >= 20 * ms);
  }
};

QTEST_APPLESS_MAIN(TestClock)
#include "tst_clock.moc"
