// SPDX-License-Identifier: Apache-2.0
#include "framework/overload.hpp"

#include <limits>
#include <stdexcept>
#include <string>

#include <QTest>

#include "framework/executor.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/executor_rig.hpp"
#include "tests/support/virtual_time.hpp"

using namespace trocar;
using test::ExecutorRig;
using test::Puppet;
using test::VirtualTime;

namespace {

constexpr qint64 us = 1'000;      // [ns]
constexpr qint64 ms = 1'000'000;  // [ns]
constexpr double period = 1e-3;   // [s]

/// The ticks of a loop of 1 kHz, by what each of them took.
class Ticks {
 public:
  explicit Ticks(const OverloadSettings& settings) : monitor(settings, period) {
    clock_.start(ms);
    monitor.judge(clock_.wait());
  }
  /// @return what the tick that takes so long trips
  Overload tick(std::int64_t takes) {
    time_.spend(takes);
    slot_ = clock_.wait();
    return monitor.judge(slot_);
  }
  /// @return the slot at which it tripped, -1 when it did not
  std::int64_t ticks(int count, std::int64_t takes) {
    for (int i = 0; i < count; ++i)
      if (tick(takes).detail != nullptr) return slot_.index;
    return -1;
  }

  OverloadMonitor monitor;

 private:
  VirtualTime time_;
  PeriodicClock clock_{0, time_};
  Slot slot_;
};

/// A loop whose component takes `takes(tick)` of virtual time, on an arm that renders 0.5 N and is
/// held by 0.25 N.
struct SlowRig : ExecutorRig {
  SlowRig() {
    add_arm();
    wire();
    get("rendering").law = [this](Puppet& self, const Tick& tick) {
      (*self.effort)[0] = 0.5;
      dts.push_back(tick.dt);
      time.spend(takes(tick.index));
    };
    get("gravity").law = [](Puppet& self, const Tick&) { (*self.effort)[1] = 0.25; };
  }
  void run(OverloadPolicy policy, std::int64_t count) {
    ExecutorOptions options{
        .ticks = count, .records = &ring, .layout = layout.get(), .overload = {.policy = policy}};
    executor = std::make_unique<Executor>(wired->main(), std::move(options));
    PeriodicClock clock(0, time);
    executor->run(clock);
    drain();
  }

  VirtualTime time;
  std::function<std::int64_t(std::int64_t)> takes = [](std::int64_t) { return 100 * us; };
  std::vector<double> dts;
};

}  // namespace

class TestOverload : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void ticks_in_time_are_no_overruns() {
    Ticks loop({.grace = 0.0, .allowed = 0, .longest = 0.0});
    QCOMPARE(loop.ticks(10'000, 999 * us), std::int64_t{-1});
    QCOMPARE(loop.ticks(10, ms), std::int64_t{-1});
    QCOMPARE(loop.monitor.overruns(), std::int64_t{0});
  }

  void a_stall_is_one_overrun_however_many_slots_it_skips() {
    Ticks loop({.grace = 0.0, .allowed = 1, .longest = 1.0});
    QVERIFY(loop.tick(15 * ms).detail == nullptr);
    QCOMPARE(loop.monitor.overruns(), std::int64_t{1});
  }

  void more_overruns_in_a_window_than_allowed_trip() {
    Ticks loop({.grace = 0.0, .allowed = 3, .window = 1.0});
    for (int i = 0; i < 3; ++i) {
      QVERIFY(loop.tick(1200 * us).detail == nullptr);
      QCOMPARE(loop.ticks(100, 100 * us), std::int64_t{-1});
    }
    const Overload overload = loop.tick(1200 * us);
    QCOMPARE(std::string(overload.detail), std::string("overruns in the window"));
    QCOMPARE(overload.value, 4.0);
    QCOMPARE(overload.limit, 3.0);
  }

  void the_window_forgets() {
    Ticks loop({.grace = 0.0, .allowed = 3, .window = 0.1});
    for (int i = 0; i < 1000; ++i) {  // an overrun in 25 slots: four in a window, never five
      const bool trips = loop.tick(1200 * us).detail != nullptr;
      QCOMPARE(trips, i >= 3);
      QCOMPARE(loop.ticks(24, 100 * us), std::int64_t{-1});
    }
    Ticks slower({.grace = 0.0, .allowed = 3, .window = 0.1});
    for (int i = 0; i < 1000; ++i) {  // in 34: three
      QVERIFY(slower.tick(1200 * us).detail == nullptr);
      QCOMPARE(slower.ticks(33, 100 * us), std::int64_t{-1});
    }
    QCOMPARE(slower.monitor.overruns(), std::int64_t{1000});
  }

  void a_window_shorter_than_the_period_holds_one() {
    Ticks loop({.grace = 0.0, .allowed = 1, .window = 1e-6, .longest = 1.0});
    QCOMPARE(loop.ticks(100, 1200 * us), std::int64_t{-1});
  }

  void too_long_without_a_tick_in_time_trips_data() {
    QTest::addColumn<qint64>("takes");  // each tick
    QTest::addColumn<int>("ticks");     // until it trips
    QTest::newRow("one of 21 ms has missed its deadline by 20 ms") << 21 * ms << 0;
    QTest::newRow("one a little longer") << 21 * ms + 1 << 1;
    QTest::newRow("two of 12 ms") << 12 * ms << 2;
    QTest::newRow("each of two periods") << 2 * ms << 11;
    QTest::newRow("each a little too long") << 1100 * us << 20;
  }
  void too_long_without_a_tick_in_time_trips() {
    QFETCH(qint64, takes);
    QFETCH(int, ticks);
    Ticks loop({.grace = 0.0, .allowed = 10'000, .longest = 0.020});
    if (ticks == 0) {
      QVERIFY(loop.tick(takes).detail == nullptr);
      QVERIFY(loop.tick(100 * us).detail == nullptr);
      return;
    }
    QCOMPARE(loop.ticks(ticks - 1, takes), std::int64_t{-1});
    const Overload overload = loop.tick(takes);
    QVERIFY(overload.detail != nullptr);
    QCOMPARE(std::string(overload.detail), std::string("no tick ended in time for so long [s]"));
    QVERIFY(overload.value > overload.limit);
    QCOMPARE(overload.limit, 0.020);
  }

  void a_tick_in_time_breaks_the_row() {
    Ticks loop({.grace = 0.0, .allowed = 10'000, .longest = 0.020});
    for (int i = 0; i < 100; ++i) {
      QVERIFY(loop.tick(15 * ms + 500 * us).detail == nullptr);
      QVERIFY(loop.tick(100 * us).detail == nullptr);
    }
  }

  void the_start_is_counted_and_not_judged() {
    Ticks loop({.grace = 0.5, .allowed = 2, .longest = 1.0});
    QCOMPARE(loop.ticks(240, 2 * ms), std::int64_t{-1});  // until slot 480
    QCOMPARE(loop.monitor.overruns(), std::int64_t{240});
    QCOMPARE(loop.ticks(100, 2 * ms), std::int64_t{504});  // the third from slot 500 on
  }

  void what_the_start_cost_is_no_part_of_a_row() {
    Ticks loop({.grace = 0.5, .allowed = 1000, .longest = 0.010});
    QCOMPARE(loop.ticks(1000, 1100 * us), std::int64_t{510});
  }

  void each_overrun_beyond_a_limit_trips_anew() {
    Ticks loop({.grace = 0.0, .allowed = 2, .longest = 1.0});
    QVERIFY(loop.ticks(3, 1200 * us) >= 0);
    QVERIFY(loop.tick(1200 * us).detail != nullptr);
    QVERIFY(loop.tick(100 * us).detail == nullptr);
    QVERIFY(loop.tick(1200 * us).detail != nullptr);
  }

  void a_setting_out_of_its_range_is_refused_data() {
    QTest::addColumn<double>("grace");
    QTest::addColumn<int>("allowed");
    QTest::addColumn<double>("window");
    QTest::addColumn<double>("longest");
    QTest::addColumn<QString>("says");
    QTest::newRow("a negative grace") << -1.0 << 1 << 1.0 << 1.0 << "overload.grace = -1: 0 s to";
    QTest::newRow("no number") << std::numeric_limits<double>::quiet_NaN() << 1 << 1.0 << 1.0
                               << "overload.grace = nan";
    QTest::newRow("a negative count") << 0.0 << -1 << 1.0 << 1.0 << "overload.allowed = -1: 0 to";
    QTest::newRow("too many") << 0.0 << 10'001 << 1.0 << 1.0 << "overload.allowed = 10001";
    QTest::newRow("no window") << 0.0 << 1 << 0.0 << 1.0 << "overload.window = 0: more than 0 s";
    QTest::newRow("a negative length") << 0.0 << 1 << 1.0 << -0.1 << "overload.longest = -0.1";
    QTest::newRow("a length of days") << 0.0 << 1 << 1.0 << 1e5 << "overload.longest = 100000";
  }
  void a_setting_out_of_its_range_is_refused() {
    QFETCH(double, grace);
    QFETCH(int, allowed);
    QFETCH(double, window);
    QFETCH(double, longest);
    QFETCH(QString, says);
    try {
      OverloadMonitor({.grace = grace, .allowed = allowed, .window = window, .longest = longest},
                      period);
      QFAIL("it was taken");
    } catch (const std::invalid_argument& error) {
      QVERIFY2(QString(error.what()).contains(says), error.what());
    }
  }

  void judging_allocates_nothing() {
    Ticks loop({.grace = 0.0, .allowed = 3});
    const int count = test::allocations_in([&] {
      loop.ticks(1000, 100 * us);
      for (int i = 0; i < 1000; ++i) loop.tick(1500 * us);
    });
    QCOMPARE(count, 0);
  }

  // With a loop: every tick from slot 1000 on takes 1.5 ms.
  void each_policy_data() {
    QTest::addColumn<int>("policy");
    QTest::addColumn<bool>("trips");
    QTest::addColumn<bool>("ends");
    QTest::newRow("ignore counts") << static_cast<int>(OverloadPolicy::ignore) << false << false;
    QTest::newRow("stop ends the rendering, keeps the hold and goes on")
        << static_cast<int>(OverloadPolicy::stop) << true << false;
    QTest::newRow("end ends the run as well")
        << static_cast<int>(OverloadPolicy::end) << true << true;
  }
  void each_policy() {
    QFETCH(int, policy);
    QFETCH(bool, trips);
    QFETCH(bool, ends);
    SlowRig rig;
    rig.takes = [](std::int64_t slot) { return slot < 1000 ? 100 * us : 1500 * us; };
    rig.run(static_cast<OverloadPolicy>(policy), 2000);
    const LoopStatistics& loop = rig.executor->statistics();
    QCOMPARE(loop.ticks + loop.skipped >= 2000, !ends);
    QVERIFY(loop.overruns >= 14);
    QCOMPARE(rig.arm().written[0], trips ? 0.0 : 0.5);
    QCOMPARE(rig.arm().written[1], 0.25);
    QCOMPARE(rig.executor->faults().latched(), trips);
    QCOMPARE(rig.events.back().kind, Event::Kind::ended);
    QCOMPARE(static_cast<std::int64_t>(rig.rows.size()), loop.ticks);
    if (!trips) return;
    const Fault& fault = rig.executor->faults()[0];
    QCOMPARE(fault.cause, FaultCause::overload);
    QCOMPARE(std::string(fault.component), std::string("main"));
    QVERIFY(fault.tick > 1000 && fault.tick < 1030);
    QVERIFY(fault.value > fault.limit);
    QCOMPARE(rig.executor->faults().size(), std::size_t{1});
    if (ends) QCOMPARE(rig.in_row(rig.rows.size() - 1, "arm.scale"), 0.0);
  }

  void a_few_slow_ticks_are_counted_and_change_nothing() {
    SlowRig rig;
    rig.takes = [](std::int64_t slot) { return slot % 100 == 0 ? 3500 * us : 100 * us; };
    rig.run(OverloadPolicy::stop, 5000);
    const LoopStatistics& loop = rig.executor->statistics();
    QCOMPARE(loop.overruns, std::int64_t{50});
    QCOMPARE(loop.skipped, std::int64_t{100});
    QCOMPARE(loop.ticks + loop.skipped, std::int64_t{5000});
    QVERIFY(!rig.executor->faults().latched());
    QCOMPARE(rig.arm().written[0], 0.5);
    // The step after two slots that were skipped; a component sees at most twice its period.
    QCOMPARE(rig.dts[1], 0.002);
    QCOMPARE(rig.dts[2], 0.001);
  }

  void the_gates_own_limit_holds_whatever_the_policy() {
    SlowRig rig;
    rig.takes = [](std::int64_t slot) { return slot == 1000 ? 60 * ms : 100 * us; };
    rig.run(OverloadPolicy::ignore, 2000);
    QCOMPARE(rig.executor->faults().size(), std::size_t{1});
    QCOMPARE(std::string(rig.executor->faults()[0].component), std::string("arm"));
    QCOMPARE(rig.arm().written[0], 0.0);
  }

  void an_overload_that_goes_on_cannot_be_acknowledged() {
    SlowRig rig;
    bool over = false;
    rig.takes = [&](std::int64_t slot) { return slot < 1000 || over ? 100 * us : 1500 * us; };
    std::vector<Command> schedule{{.kind = Command::Kind::acknowledge, .not_before = 2000},
                                  {.kind = Command::Kind::acknowledge, .not_before = 3000}};
    rig.get("gravity").law = [&](Puppet& self, const Tick& tick) {
      (*self.effort)[1] = 0.25;
      over = tick.index >= 2100;
    };
    ExecutorOptions options{
        .ticks = 3500, .schedule = schedule, .records = &rig.ring, .layout = rig.layout.get()};
    rig.executor = std::make_unique<Executor>(rig.wired->main(), std::move(options));
    PeriodicClock clock(0, rig.time);
    rig.executor->run(clock);
    rig.drain();
    QStringList told;
    for (const Event& event : rig.events)
      if (event.kind == Event::Kind::acknowledged || event.kind == Event::Kind::acknowledge_refused)
        told += QString("%1 %2").arg(to_string(event.kind)).arg(event.tick / 10 * 10);
    QCOMPARE(told, (QStringList{"acknowledge refused 2000", "acknowledged 3000"}));
    QVERIFY(!rig.executor->faults().latched());
  }
};

QTEST_APPLESS_MAIN(TestOverload)
#include "tst_overload.moc"
