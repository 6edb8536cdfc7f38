// SPDX-License-Identifier: Apache-2.0
#include "framework/clock.hpp"

#include <QTest>

using namespace trocar;

namespace {

constexpr std::int64_t ms = 1'000'000;  // [ns]

void spend(std::int64_t nanoseconds) {
  const std::int64_t end = monotonic_ns() + nanoseconds;
  while (monotonic_ns() < end) {
  }
}

}  // namespace

class TestClock : public QObject {
  Q_OBJECT

 private slots:
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
