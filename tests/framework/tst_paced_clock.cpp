// SPDX-License-Identifier: Apache-2.0
#include "framework/paced_clock.hpp"

#include <QTest>
#include <deque>
#include <random>
#include <stdexcept>

#include "tests/support/virtual_time.hpp"

using namespace trocar;
using trocar::test::VirtualTime;

namespace {

constexpr std::int64_t period = 1'000'000;  // [ns]

/// Beats at the dates that the test says.
class ScriptedPacer final : public Pacer {
 public:
  explicit ScriptedPacer(VirtualTime& time) : time_(time) {}
  std::int64_t period_ns() const override { return theirs; }
  bool wait_for_beat(std::int64_t date_ns, Beat& beat) RT_SAFE override {
    bool found = false;
    while (!beats.empty() && beats.front().date_ns <= time_.now_ns) {
      beat = beats.front();
      beats.pop_front();
      found = true;
    }
    if (found) return true;
    if (beats.empty() || beats.front().date_ns > date_ns) {
      time_.sleep_until(date_ns);
      return false;
    }
    time_.sleep_until(beats.front().date_ns);
    beat = beats.front();
    beats.pop_front();
    return true;
  }
  /// The k-th beat, `late` after it is due.
  void beat(std::int64_t k, std::int64_t late = 0) {
    beats.push_back({own_start + k * period, start + k * period + late});
  }

  std::deque<Beat> beats;
  std::int64_t theirs = period;
  std::int64_t start = 10 * period, own_start = 777'000;

 private:
  VirtualTime& time_;
};

struct Bench {
  VirtualTime time;
  ScriptedPacer pacer{time};
  PacedClock clock{pacer, time};

  Bench() {
    time.now_ns = pacer.start - 10'000;
    clock.start(period);
  }
};

}  // namespace

class TestPacedClock : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void each_beat_begins_a_tick() {
    Bench bench;
    for (std::int64_t k = 0; k < 1000; ++k) bench.pacer.beat(k, k % 7 * 10'000);
    for (std::int64_t k = 0; k < 1000; ++k) {
      const Slot slot = bench.clock.wait();
      QCOMPARE(slot.index, k);
      QCOMPARE(slot.skipped, std::int64_t{0});
      QCOMPARE(slot.lateness_ns, std::int64_t{0});
      QCOMPARE(slot.overrun_ns, std::int64_t{0});
      QCOMPARE(slot.date_ns, bench.pacer.start + k * period + k % 7 * 10'000);
      bench.time.spend(300'000);
    }
  }

  void the_first_tick_is_begun_by_a_beat_of_after_the_start() {
    VirtualTime time;
    ScriptedPacer pacer(time);
    PacedClock clock(pacer, time);
    pacer.beat(0);
    time.now_ns = pacer.start + 14 * period + 100'000;
    clock.start(period);
    pacer.beat(19);
    const Slot slot = clock.wait();
    QCOMPARE(slot.index, std::int64_t{0});
    QCOMPARE(slot.skipped, std::int64_t{0});
    QCOMPARE(slot.date_ns, pacer.start + 19 * period);
    QCOMPARE(slot.lateness_ns, std::int64_t{0});
  }

  void without_any_beat_it_begins_by_itself() {
    Bench bench;
    const std::int64_t start = bench.time.now_ns;
    QCOMPARE(bench.clock.wait().date_ns, start + 20'000'000);
    QCOMPARE(bench.clock.wait().date_ns, start + 21'000'000);
  }

  void waking_up_late_is_lateness() {
    Bench bench;
    bench.pacer.beat(0);
    bench.time.wake_up = [] { return std::int64_t{50'000}; };
    QCOMPARE(bench.clock.wait().lateness_ns, std::int64_t{50'000});
  }

  void a_beat_that_never_came_leaves_its_slot_skipped() {
    Bench bench;
    for (const std::int64_t k : {0, 1, 2, 4}) bench.pacer.beat(k, k == 4 ? -600'000 : 0);
    for (int i = 0; i < 3; ++i) bench.clock.wait();
    const Slot slot = bench.clock.wait();
    QCOMPARE(slot.index, std::int64_t{4});
    QCOMPARE(slot.skipped, std::int64_t{1});
  }

  void a_tick_that_took_long_meets_the_newest_beat() {
    Bench bench;
    for (std::int64_t k = 0; k < 10; ++k) bench.pacer.beat(k);
    bench.clock.wait();
    bench.time.spend(3'400'000);
    const Slot slot = bench.clock.wait();
    QCOMPARE(slot.index, std::int64_t{3});
    QCOMPARE(slot.skipped, std::int64_t{2});
    QCOMPARE(slot.overrun_ns, std::int64_t{2'400'000});
    QCOMPARE(slot.lateness_ns, std::int64_t{400'000});
    QCOMPARE(bench.clock.wait().index, std::int64_t{4});
  }

  void when_beats_stop_it_goes_on_by_itself() {
    Bench bench;
    bench.pacer.beat(0);
    bench.pacer.beat(1);
    bench.clock.wait();
    bench.clock.wait();
    std::int64_t before = bench.time.now_ns;
    for (std::int64_t k = 2; k < 20; ++k) {
      const Slot slot = bench.clock.wait();
      QCOMPARE(slot.index, k);
      QCOMPARE(slot.skipped, std::int64_t{0});
      QCOMPARE(slot.date_ns - before, k == 2 ? period + period / 2 : period);
      before = slot.date_ns;
    }
    // Beats come back where the pacer's own time is.
    bench.pacer.beat(20);
    const Slot back = bench.clock.wait();
    QCOMPARE(back.index, std::int64_t{20});
    QCOMPARE(back.skipped, std::int64_t{0});
  }

  void a_pacer_that_starts_anew_goes_on_in_the_next_slot() {
    for (const std::int64_t leap : {-5'000'000'000, 5'000'000'000}) {
      Bench bench;
      bench.pacer.beat(0);
      bench.clock.wait();
      bench.pacer.own_start += leap;
      bench.pacer.beat(1);
      bench.pacer.beat(2);
      QCOMPARE(bench.clock.wait().index, std::int64_t{1});
      QCOMPARE(bench.clock.wait().index, std::int64_t{2});
    }
  }

  void slots_used_and_skipped_are_the_pacers_periods() {
    Bench bench;
    std::mt19937 random(1);
    std::int64_t last = 0;
    for (std::int64_t k = 0; k < 100'000; ++k) {
      if (k != 0 && random() % 5 == 0) continue;
      bench.pacer.beat(k, static_cast<std::int64_t>(random() % 200'000));
      last = k;
    }
    std::int64_t used = 0, skipped = 0, index = -1;
    while (!bench.pacer.beats.empty()) {
      const Slot slot = bench.clock.wait();
      QVERIFY(slot.index > index);
      QCOMPARE(slot.index, index + 1 + slot.skipped);
      index = slot.index;
      ++used;
      skipped += slot.skipped;
      bench.time.spend(random() % 100 == 0 ? 2'500'000 : 100'000);
    }
    QCOMPARE(used + skipped, index + 1);
    QVERIFY2(std::abs(index - last) <= 2, "by the pacer's own time, to what it went on by itself");
  }

  void another_period_is_refused() {
    VirtualTime time;
    ScriptedPacer pacer(time);
    PacedClock clock(pacer, time);
    clock.start(1'009'000);
    try {
      clock.start(250'000);
      QFAIL("taken");
    } catch (const std::invalid_argument& error) {
      QCOMPARE(QString(error.what()),
               QString("a rate of 4000 Hz cannot be paced by a device that reports at 1000 Hz: set "
                       "rate = \"1000 Hz\", or take --clock realtime"));
    }
  }
};

QTEST_APPLESS_MAIN(TestPacedClock)
#include "tst_paced_clock.moc"
