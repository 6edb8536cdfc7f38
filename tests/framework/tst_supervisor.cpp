// SPDX-License-Identifier: Apache-2.0
#include "framework/supervisor.hpp"

#include <QTest>

#include "framework/loop_runner.hpp"
#include "tests/support/executor_rig.hpp"
#include "tests/support/virtual_time.hpp"

using namespace trocar;
using test::ExecutorRig;
using test::Puppet;
using test::TestDevice;
using test::VirtualTime;

namespace {

constexpr qint64 ms = 1'000'000;  // [ns]

/// An arm that renders 0.5 N and is held by 0.25 N, ticked as the periodic clock would.
struct StallRig : ExecutorRig {
  explicit StallRig(OverloadPolicy policy = OverloadPolicy::stop) {
    add_arm();
    wire();
    get("rendering").law = [](Puppet& self, const Tick&) { (*self.effort)[0] = 0.5; };
    get("gravity").law = [](Puppet& self, const Tick&) { (*self.effort)[1] = 0.25; };
    start({.overload = {.policy = policy}});
  }
  void tick(int count) {
    for (int i = 0; i < count; ++i)
      executor->tick({.index = next++, .date_ns = monotonic_ns()}, false);
    drain();
  }
  /// As if nothing had come from the loop for so long.
  void watch(std::int64_t silence_ns) {
    Supervisor supervisor(
        {{&executor->heartbeat(), heartbeat_patience(ms), executor->group().devices()}});
    supervisor.look(monotonic_ns() + silence_ns);
  }
};

}  // namespace

class TestSupervisor : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void patience_is_three_periods_and_at_most_4800_us() {
    QCOMPARE(heartbeat_patience(100'000), qint64{300'000});
    QCOMPARE(heartbeat_patience(ms), 3 * ms);
    QCOMPARE(heartbeat_patience(2 * ms), qint64{4'800'000});
    QCOMPARE(heartbeat_patience(4 * ms), 6 * ms);
    QCOMPARE(heartbeat_patience(10 * ms), 15 * ms);
  }

  void it_looks_four_times_within_the_shortest_patience() {
    Heartbeat slow, fast;
    QCOMPARE(Supervisor({{&slow, 6 * ms}, {&fast, 3 * ms}}).interval_ns(), qint64{750'000});
    QCOMPARE(Supervisor({{&fast, 300'000}}).interval_ns(), qint64{100'000});
  }

  void a_hung_loop_is_told_of_before_6_ms_and_once_data() {
    QTest::addColumn<qint64>("period");
    QTest::newRow("10 kHz") << ms / 10;
    QTest::newRow("1 kHz") << ms;
    QTest::newRow("500 Hz") << 2 * ms;
  }
  void a_hung_loop_is_told_of_before_6_ms_and_once() {
    QFETCH(qint64, period);
    const std::int64_t patience = heartbeat_patience(period);
    for (std::int64_t last_beat = 10 * ms; last_beat < 12 * ms; last_beat += 10'000) {
      Heartbeat hung, sound;
      TestDevice arm, other;
      Device* const arms[] = {&arm};
      Device* const others[] = {&other};
      Supervisor supervisor({{&hung, patience, arms}, {&sound, patience, others}});
      std::int64_t told = 0;
      for (std::int64_t now = ms; now < 30 * ms; now += supervisor.interval_ns()) {
        if (now <= last_beat) hung.beat(now);
        sound.beat(now);
        supervisor.look(now);
        if (now <= last_beat) hung.beat(last_beat);
        if (told == 0 && arm.stalls > 0) told = now;
      }
      QVERIFY(told - last_beat > patience && told - last_beat <= 6 * ms);
      QCOMPARE(arm.stalls.load(), 1);
      QCOMPARE(other.stalls.load(), 0);
    }
  }

  void it_ends_with_the_last_loop() {
    Heartbeat first, second;
    VirtualTime time;
    time.wake_up = [&] {
      if (time.sleeps == 5) first.end();
      if (time.sleeps == 9) second.end();
      return std::int64_t{0};
    };
    Supervisor({{&first, 3 * ms}, {&second, 3 * ms}}).run(time);
    QCOMPARE(time.sleeps, 9);
  }

  void a_loop_that_comes_back_latches_and_renders_no_more() {
    StallRig rig;
    rig.tick(600);
    QCOMPARE(rig.arm().written[0], 0.5);
    rig.watch(4 * ms);
    QCOMPARE(rig.arm().stalls.load(), 1);
    rig.tick(1);
    QCOMPARE(rig.arm().written[0], 0.0);
    QCOMPARE(rig.arm().written[1], 0.25);
    const Fault& fault = rig.executor->faults()[0];
    QCOMPARE(std::string(to_string(fault.cause)), std::string("loop stalled"));
    QCOMPARE(std::string(fault.component), std::string("main"));
    QCOMPARE(fault.limit, 3e-3);
    rig.tick(10);
    QCOMPARE(rig.executor->faults().size(), std::size_t{1});
  }

  void the_component_that_hung_is_named() {
    StallRig rig;
    rig.tick(600);
    rig.get("gravity").law = [](Puppet&, const Tick&) {
      const std::int64_t end = monotonic_ns() + 50 * ms;
      while (monotonic_ns() < end) {
      }
    };
    rig.tick(1);
    rig.watch(0);
    rig.get("gravity").law = [](Puppet&, const Tick&) {};
    rig.tick(1);
    const Fault& fault = rig.executor->faults()[0];
    QCOMPARE(std::string(to_string(fault.cause)), std::string("loop stalled"));
    QCOMPARE(std::string(fault.component), std::string("gravity"));
  }

  void policies() {
    StallRig ignoring(OverloadPolicy::ignore);
    ignoring.tick(600);
    ignoring.watch(4 * ms);
    ignoring.tick(1);
    QCOMPARE(ignoring.executor->faults().size(), std::size_t{0});

    StallRig ending(OverloadPolicy::end);
    ending.tick(600);
    ending.watch(4 * ms);
    ending.tick(1);
    QVERIFY(ending.executor->over());
  }

  void the_start_is_not_judged() {
    StallRig rig;
    rig.tick(100);
    rig.watch(4 * ms);
    rig.tick(1);
    QCOMPARE(rig.executor->faults().size(), std::size_t{0});
    QCOMPARE(rig.arm().written[0], 0.5);
  }

  /// On the machine's own threads: a component hangs until the supervisor has seen it.
  void a_component_that_hangs_is_found_by_the_supervisors_thread() {
    ExecutorRig rig;
    rig.add_arm();
    rig.wire();
    TestDevice& arm = rig.arm();
    rig.get("rendering").law = [&](Puppet&, const Tick& tick) {
      if (tick.index != 20) return;
      const std::int64_t patience = monotonic_ns() + 10'000 * ms;
      while (arm.stalls == 0 && monotonic_ns() < patience) {
      }
    };
    std::deque<Executor> executors;
    executors.emplace_back(rig.wired->main(),
                           ExecutorOptions{.ticks = 40, .overload = {.grace = 0.0}});
    run_in_real_time(executors, 0);
    QVERIFY(arm.stalls >= 1);
    QVERIFY(executors[0].faults().latched());
  }
};

QTEST_GUILESS_MAIN(TestSupervisor)
#include "tst_supervisor.moc"
