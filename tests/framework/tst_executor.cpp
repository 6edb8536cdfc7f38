// SPDX-License-Identifier: Apache-2.0
#include "framework/executor.hpp"

#include <QTest>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/executor_rig.hpp"

using namespace trocar;
using test::ExecutorRig;
using test::Puppet;
using test::PuppetFixture;
using test::PuppetMotion;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
using Lines = std::vector<std::string>;

void compare(const Lines& told, const Lines& expected) {
  QStringList a, b;
  for (const std::string& line : told) a += QString::fromStdString(line);
  for (const std::string& line : expected) b += QString::fromStdString(line);
  QCOMPARE(a, b);
}

/// An arm that renders 0.5 N and is held by 0.25 N.
struct ArmRig : ExecutorRig {
  ArmRig() {
    add_arm();
    wire();
    get("rendering").law = [](Puppet& self, const Tick&) { (*self.effort)[0] = 0.5; };
    get("gravity").law = [](Puppet& self, const Tick&) { (*self.effort)[1] = 0.25; };
  }
  double rendered() { return arm().written[0]; }
  double held() { return arm().written[1]; }
};

/// Two fixtures of -1 N and -0.25 N along x on a tool that moves along x, whose hold is sound.
struct FixtureRig : ExecutorRig {
  explicit FixtureRig(double rate_of_failing = 0.0) {
    const NodeId arm_node = add("TestDevice", "arm");
    const NodeId motion_node = add("PuppetMotion", "motion");
    const NodeId statics = add("PuppetStatics", "statics");
    for (const char* name : {"failing", "other"}) {
      const NodeId node = add("PuppetFixture", name);
      connect(motion_node, "velocity", node, "velocity");
      connect(node, "force", statics, "forces");
      connect(node, "moment", statics, "moments");
      if (rate_of_failing > 0.0 && std::string(name) == "failing")
        graph.set_rate(node, rate_of_failing, 0, {"test", 1});
    }
    connect(statics, "effort", arm_node, "effort");
    wire();
    get<PuppetFixture>("other").law = [](PuppetFixture& self, const Tick&) {
      *self.force = {-0.25, 0.0, 0.0};
    };
    start();
  }
  /// Fails at tick 5, where it leaves `last` in its force.
  void fail_at_5(double last) {
    get<PuppetFixture>("failing").law = [last](PuppetFixture& self, const Tick& tick) {
      *self.force = {-1.0, 0.0, 0.0};
      *self.moment = {0.0, 0.0, 0.5};
      if (tick.index < 5) return;
      self.force->x = last;
      self.fail("line 3: broken");
    };
  }
  void move(double speed) { *get<PuppetMotion>("motion").velocity = {speed, 0.0, 0.0}; }
  double force() { return get<PuppetFixture>("failing").force->x; }
};

}  // namespace

class TestExecutor : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_tick_is_commands_devices_steps_gate_row() {
    ArmRig rig;
    QCOMPARE(rig.wired->main().schedule().front().component, &rig.arm());
    int writes_before_step = -1;
    double gain_in_step = -1.0;
    rig.get("rendering").law = [&](Puppet& self, const Tick&) {
      writes_before_step = rig.arm().writes;
      gain_in_step = *self.gain;
      (*self.effort)[0] = *self.gain;
    };
    rig.start({.edit_ramp = 0.0});
    rig.commands.try_push(rig.edit("rendering", "gain", 0.75));
    rig.run();
    QCOMPARE(gain_in_step, 0.75);     // commands before steps
    QCOMPARE(writes_before_step, 0);  // steps before the gate
    QCOMPARE(rig.rendered(), 0.75);
    QCOMPARE(rig.in_row(0, "arm.effort_sent.axis1"), 0.75);  // the gate before the row
  }

  void start_and_stop_are_called_once_in_order_and_in_reverse() {
    ArmRig rig;
    Lines calls;
    rig.get("rendering").calls = rig.get("gravity").calls = &calls;
    Executor executor(rig.wired->main(), {.ticks = 3});
    SimulatedClock clock;
    executor.run(clock);
    compare(calls, {"rendering start", "gravity start", "gravity stop", "rendering stop"});
    QCOMPARE(executor.statistics().ticks, std::int64_t{3});
  }

  void a_slow_component_steps_at_its_phase_data() {
    QTest::addColumn<double>("rate");
    QTest::addColumn<int>("phase");
    QTest::addColumn<QList<int>>("expected");
    QTest::newRow("every tick") << 1000.0 << 0 << QList<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    QTest::newRow("every second") << 500.0 << 0 << QList<int>{0, 2, 4, 6, 8};
    QTest::newRow("every fourth, one later") << 250.0 << 1 << QList<int>{1, 5, 9};
    QTest::newRow("every fifth, at the last phase") << 200.0 << 4 << QList<int>{4, 9};
  }
  void a_slow_component_steps_at_its_phase() {
    QFETCH(double, rate);
    QFETCH(int, phase);
    QFETCH(QList<int>, expected);
    ExecutorRig rig;
    rig.graph.set_rate(rig.add("Puppet", "slow"), rate, phase, {"test", 1});
    rig.wire();
    rig.start();
    rig.run(10);
    QList<int> at;
    for (const Tick& tick : rig.get("slow").steps) {
      at += static_cast<int>(tick.index);
      QCOMPARE(tick.dt, 1.0 / rate);
      QCOMPARE(tick.time, static_cast<double>(tick.index) * 1e-3);
    }
    QCOMPARE(at, expected);
    QCOMPARE(rig.executor->statistics().components[0].count(),
             static_cast<std::uint64_t>(expected.size()));
  }

  void a_component_that_is_not_due_takes_no_time() {
    ExecutorRig rig;
    rig.graph.set_rate(rig.add("Puppet", "slow"), 500.0, 0, {"test", 1});
    rig.wire();
    rig.start();
    for (std::int64_t i = 0; i < 2; ++i) rig.executor->tick({i, 0, 0}, false);
    rig.drain();
    std::int64_t time = -1;
    std::memcpy(&time, rig.rows[1].data() + sizeof(RowHeader), sizeof time);
    QCOMPARE(time, std::int64_t{0});
    QCOMPARE(rig.executor->statistics().components[0].count(), std::uint64_t{1});
  }

  void a_skipped_slot_costs_a_slow_component_no_turn() {
    ExecutorRig rig;
    rig.graph.set_rate(rig.add("Puppet", "slow"), 250.0, 0, {"test", 1});
    rig.wire();
    rig.start();
    rig.run();    // slot 0
    rig.skip(4);  // 5: its turn at 4 was skipped
    rig.run(3);   // 6, 7, 8: back on its raster
    const std::vector<Tick>& steps = rig.get("slow").steps;
    QCOMPARE(steps.size(), std::size_t{3});
    QCOMPARE(steps[1].index, std::int64_t{5});
    QCOMPARE(steps[2].index, std::int64_t{8});
    QCOMPARE(steps[1].dt, 5e-3);
    QCOMPARE(steps[2].dt, 3e-3);
  }

  void the_step_is_measured_and_clamped_data() {
    QTest::addColumn<int>("divider");
    QTest::addColumn<int>("skipped");
    QTest::addColumn<double>("expected");  // [s]
    QTest::newRow("one slot on") << 1 << 0 << 1e-3;
    QTest::newRow("one was skipped") << 1 << 1 << 2e-3;
    QTest::newRow("at most twice the period") << 1 << 7 << 2e-3;
    QTest::newRow("of a slow one too") << 4 << 20 << 8e-3;
  }
  void the_step_is_measured_and_clamped() {
    QFETCH(int, divider);
    QFETCH(int, skipped);
    QFETCH(double, expected);
    ExecutorRig rig;
    rig.graph.set_rate(rig.add("Puppet", "one"), 1000.0 / divider, 0, {"test", 1});
    rig.wire();
    rig.start();
    rig.run();
    rig.skip(skipped);
    QCOMPARE(rig.get("one").steps.back().dt, expected);
  }

  void a_step_that_follows_soon_is_at_least_half_the_period() {
    ExecutorRig rig;
    rig.graph.set_rate(rig.add("Puppet", "slow"), 100.0, 0, {"test", 1});
    rig.wire();
    rig.start();
    rig.skip(19);  // slot 19 stands in for 0 and 10
    rig.run(1);
    QCOMPARE(rig.get("slow").steps.size(), std::size_t{2});
    QCOMPARE(rig.get("slow").steps[1].dt, 5e-3);
  }

  void an_edit_ramps_along_a_line_and_ends_exactly_at_its_target() {
    ExecutorRig rig;
    // Numbers of which start + (target - start) is not the target.
    rig.graph.set({rig.add("Puppet", "one"), "gain"}, literal_from_text("0.2 N"), {"test", 1});
    rig.wire();
    rig.start({.schedule = {rig.edit("one", "gain", 0.9, 100)}});
    std::vector<double> gains;
    rig.get("one").law = [&](Puppet& self, const Tick&) { gains.push_back(*self.gain); };
    rig.run(400);
    QCOMPARE(gains[99], 0.2);
    for (std::size_t k = 0; k < 200; ++k)
      QVERIFY(std::abs(gains[100 + k] - 0.2 - 0.7 * static_cast<double>(k + 1) / 200.0) < 1e-15);
    for (std::size_t k = 299; k < 400; ++k) QVERIFY(gains[k] == 0.9);
  }

  void all_numbers_of_a_parameter_move_together() {
    ExecutorRig rig;
    rig.add("Puppet", "one");
    rig.wire();
    Command edit = rig.edit("one", "shift", 0.0);
    edit.target = {1.0, -2.0, 4.0};
    rig.start({.schedule = {edit}});
    rig.run(100);
    QCOMPARE(rig.get("one").shift->x, 0.5);
    QCOMPARE(rig.get("one").shift->y, -1.0);
    rig.run(100);
    QVERIFY(rig.get("one").shift->z == 4.0);
  }

  void an_edit_of_a_moving_parameter_starts_from_where_it_is() {
    ExecutorRig rig;
    rig.add("Puppet", "one");
    rig.wire();
    rig.start({.schedule = {rig.edit("one", "gain", 1.0, 0), rig.edit("one", "gain", 0.0, 100)}});
    std::vector<double> gains;
    rig.get("one").law = [&](Puppet& self, const Tick&) { gains.push_back(*self.gain); };
    rig.run(301);
    QCOMPARE(gains[99], 0.5);
    QCOMPARE(gains[100], 0.5 * 199.0 / 200.0);
    QCOMPARE(gains[199], 0.25);
    QCOMPARE(gains[300], 0.0);
  }

  void commands_wait_for_their_tick_whatever_their_order() {
    ExecutorRig rig;
    rig.add("Puppet", "one");
    rig.wire();
    rig.start({.schedule = {rig.edit("one", "gain", 2.0, 7), rig.edit("one", "gain", 1.0, 3)}});
    rig.run(10);
    compare(rig.told(), {"0 started", "3 edit one: gain", "7 edit one: gain"});
    QCOMPARE(rig.events[1].value, 1.0);
    QCOMPARE(rig.events[2].time_ns, std::int64_t{7'000'000});
  }

  void an_edit_beyond_those_that_can_move_at_a_time_is_refused() {
    ExecutorRig rig;
    for (std::size_t i = 0; i <= ParameterRamps::capacity; ++i)
      rig.add("Puppet", "p" + std::to_string(i));
    rig.wire();
    std::vector<Command> edits;
    for (const ScheduleItem& item : rig.wired->main().schedule())
      edits.push_back(rig.edit(item.component->name(), "gain", 1.0));
    rig.start({.schedule = edits});
    rig.run(200);
    QCOMPARE(rig.told().back(), std::string("0 edit refused p32: too many edits at a time"));
    QCOMPARE(*rig.get("p31").gain, 1.0);
    QCOMPARE(*rig.get("p32").gain, 0.0);
  }

  void what_is_not_finite_never_reaches_the_motors_and_hold_stays_data() {
    QTest::addColumn<double>("value");
    QTest::newRow("not a number") << not_a_number;
    QTest::newRow("infinity") << std::numeric_limits<double>::infinity();
    QTest::newRow("minus infinity") << -std::numeric_limits<double>::infinity();
  }
  void what_is_not_finite_never_reaches_the_motors_and_hold_stays() {
    QFETCH(double, value);
    ArmRig rig;
    rig.get("rendering").law = [&](Puppet& self, const Tick& tick) {
      (*self.effort)[0] = 0.5;
      // Not what the device reads: what is computed along with it is not to be trusted either.
      *self.number = tick.index >= 5 && tick.index < 8 ? value : 0.0;
    };
    rig.start();
    rig.run(5);
    QCOMPARE(rig.rendered(), 0.5);
    rig.run();  // in that same tick
    QCOMPARE(rig.rendered(), 0.0);
    QCOMPARE(rig.held(), 0.25);
    rig.run(20);
    QCOMPARE(rig.rendered(), 0.0);  // though it is sound again
    QCOMPARE(rig.held(), 0.25);
    QCOMPARE(rig.executor->faults().size(), std::size_t{1});
    QCOMPARE(rig.executor->faults()[0].tick, std::int64_t{5});
    compare(rig.told(), {"0 started", "5 fault rendering: not finite", "5 gate arm: tripped"});
  }

  void what_is_huge_but_finite_is_no_fault() {
    ArmRig rig;
    rig.get("rendering").law = [](Puppet& self, const Tick&) {
      *self.number = std::numeric_limits<double>::max();
      (*self.effort)[0] = 0.5;
    };
    rig.get("gravity").law = [](Puppet& self, const Tick&) {
      *self.number = std::numeric_limits<double>::max();
    };
    rig.start();
    rig.run(3);
    QCOMPARE(rig.rendered(), 0.5);
    compare(rig.told(), {"0 started"});
  }

  void a_hold_that_is_not_finite_leaves_nothing() {
    ArmRig rig;
    rig.get("gravity").law = [](Puppet& self, const Tick& tick) {
      *self.number = tick.index == 5 ? not_a_number : 0.0;
      (*self.effort)[1] = 0.25;
    };
    rig.start();
    rig.run(5);
    QCOMPARE(rig.held(), 0.25);
    rig.run();
    QCOMPARE(rig.held(), 0.0);
    QCOMPARE(rig.rendered(), 0.0);
    QCOMPARE(std::string(rig.executor->faults()[0].component), std::string("gravity"));
  }

  void what_reaches_no_device_is_a_fault_that_stops_nothing() {
    ExecutorRig rig;
    rig.add_arm();
    rig.add("Puppet", "plotted");
    rig.wire();
    rig.get("rendering").law = [](Puppet& self, const Tick&) { (*self.effort)[0] = 0.5; };
    rig.get("plotted").law = [](Puppet& self, const Tick&) { *self.number = not_a_number; };
    rig.start();
    rig.run(10);
    QCOMPARE(rig.arm().written[0], 0.5);
    compare(rig.told(), {"0 started", "0 fault plotted: not finite"});
    QVERIFY(header_of(rig.rows.back()).flags & RowHeader::fault_latched);
    QVERIFY(header_of(rig.rows.back()).flags & RowHeader::rendering);
  }

  void such_a_fault_can_be_acknowledged() {
    ExecutorRig rig;
    rig.add_arm();
    rig.add("Puppet", "plotted");
    rig.wire();
    rig.get("plotted").law = [](Puppet& self, const Tick& tick) {
      *self.number = tick.index == 3 ? not_a_number : 0.0;
    };
    rig.start();
    rig.run(5);
    rig.commands.try_push({.kind = Command::Kind::acknowledge});
    rig.run();
    QVERIFY(!rig.executor->faults().latched());
    QCOMPARE(rig.told().back(), std::string("5 acknowledged"));
    rig.commands.try_push({.kind = Command::Kind::acknowledge});
    rig.run();
    QCOMPARE(rig.told().back(), std::string("6 acknowledge refused: no fault is latched"));
  }

  void a_failed_fixture_that_resists_fades_within_10_ms() {
    FixtureRig rig;
    rig.move(0.1);
    rig.fail_at_5(-1.0);
    rig.run(5);
    QCOMPARE(rig.arm().written[0], -1.25);
    double before = 1.0;
    for (int ms = 1; ms <= 10; ++ms) {
      rig.run();
      QVERIFY(-rig.force() <= 1.0 - 0.1 * ms + 1e-12);
      QVERIFY(-rig.force() <= before);
      before = -rig.force();
    }
    QCOMPARE(rig.force(), 0.0);
    QCOMPARE(rig.get<PuppetFixture>("failing").steps, 6);
    QCOMPARE(rig.arm().written[0], -0.25);  // the other renders on
    QCOMPARE(rig.executor->gates()[0].state(), Gate::State::engaged);
    compare(rig.told(), {"0 started", "5 fault failing: component failed"});
    QCOMPARE(std::string(rig.executor->faults()[0].detail), std::string("line 3: broken"));
  }

  void a_failed_fixture_that_pushes_along_is_zero_at_once_data() {
    QTest::addColumn<int>("turns_at");  // tick from which the tool moves along the force
    QTest::newRow("when it fails") << 0;
    QTest::newRow("while it fades") << 8;
  }
  void a_failed_fixture_that_pushes_along_is_zero_at_once() {
    QFETCH(int, turns_at);
    FixtureRig rig;
    rig.fail_at_5(-1.0);
    for (int tick = 0; tick < 20; ++tick) {
      rig.move(tick >= turns_at ? -0.1 : 0.1);
      rig.run();
      if (tick >= 5 && tick >= turns_at) QCOMPARE(rig.force(), 0.0);
      if (tick >= 5 && tick < turns_at) QVERIFY(rig.force() < 0.0);
    }
  }

  void a_slow_fixture_that_failed_is_watched_in_every_tick() {
    FixtureRig rig(200.0);
    rig.fail_at_5(-1.0);
    rig.move(0.1);
    rig.run(7);
    QVERIFY(rig.force() < 0.0);
    rig.move(-0.1);
    rig.run();
    QCOMPARE(rig.force(), 0.0);
  }

  void what_a_fixture_wrote_while_it_failed_is_not_used_data() {
    QTest::addColumn<double>("last");
    QTest::newRow("half a result") << -8.0;
    QTest::newRow("the other direction") << 4.0;
    QTest::newRow("not a number") << not_a_number;
  }
  void what_a_fixture_wrote_while_it_failed_is_not_used() {
    QFETCH(double, last);
    FixtureRig rig;
    rig.move(0.1);
    rig.fail_at_5(last);
    rig.run(6);
    QCOMPARE(rig.force(), -0.9);  // of what it wrote before
    QCOMPARE(rig.executor->faults().size(), std::size_t{1});
  }

  void the_moment_of_a_failed_fixture_is_gone() {
    FixtureRig rig;
    rig.move(0.1);
    rig.fail_at_5(-1.0);
    rig.run(5);
    QCOMPARE(rig.arm().written[2], 0.5);
    rig.run();
    QCOMPARE(rig.arm().written[2], 0.0);
  }

  void a_failed_component_that_is_no_fixture_ends_the_rendering() {
    ArmRig rig;
    rig.get("rendering").law = [](Puppet& self, const Tick& tick) {
      (*self.effort)[0] = 0.5;
      if (tick.index == 5) self.fail("no data");
    };
    rig.start();
    rig.run(5);
    QCOMPARE(rig.rendered(), 0.5);
    rig.run();
    QCOMPARE(rig.rendered(), 0.0);
    QCOMPARE(rig.held(), 0.25);
    rig.run(200);
    rig.commands.try_push({.kind = Command::Kind::acknowledge});
    rig.run();
    QCOMPARE(rig.told().back(), std::string("206 acknowledge refused arm"));  // it stays failed
    QCOMPARE(rig.get("rendering").steps.size(), std::size_t{6});
  }

  void a_failed_device_gets_nothing_any_more() {
    ArmRig rig;
    rig.arm().law = [](test::TestDevice& self, const Tick& tick) {
      if (tick.index == 5) self.fail("unplugged");
    };
    rig.start();
    rig.run(5);
    QCOMPARE(rig.held(), 0.25);
    rig.run();
    QCOMPARE(rig.held(), 0.0);
    QCOMPARE(rig.rendered(), 0.0);
    compare(rig.told(), {"0 started", "5 fault arm: component failed", "5 gate arm: tripped"});
  }

  void the_operator_stops_the_rendering_and_hold_stays() {
    ArmRig rig;
    rig.start();
    rig.run(5);
    rig.commands.try_push({.kind = Command::Kind::stop_rendering});
    rig.run(2);
    QCOMPARE(rig.rendered(), 0.0);
    QCOMPARE(rig.held(), 0.25);
    compare(rig.told(), {"0 started", "5 fault arm: operator stop", "5 gate arm: tripped"});
  }

  void an_acknowledged_fault_leads_to_holding_and_never_to_engaged() {
    ArmRig rig;
    rig.start();
    rig.commands.try_push({.kind = Command::Kind::stop_rendering});
    rig.run();
    rig.commands.try_push({.kind = Command::Kind::acknowledge});
    rig.run();  // too soon
    rig.run(200);
    rig.commands.try_push({.kind = Command::Kind::acknowledge});
    rig.run(2000);
    compare(rig.told(),
            {"0 started", "0 fault arm: operator stop", "0 gate arm: tripped",
             "1 acknowledge refused arm", "202 acknowledged arm", "202 gate arm: holding"});
    QCOMPARE(rig.rendered(), 0.0);
    rig.commands.try_push({.kind = Command::Kind::engage});
    rig.run(2000);
    QCOMPARE(rig.told().back(), std::string("2702 gate arm: engaged"));
    QCOMPARE(rig.rendered(), 0.5);
  }

  void a_run_ends_data() {
    QTest::addColumn<int>("ticks");
    QTest::addColumn<int>("end_at");
    QTest::addColumn<bool>("stopped");
    QTest::addColumn<int>("expected");
    QTest::newRow("after its ticks") << 12 << -1 << false << 12;
    QTest::newRow("before it begins when it has none") << 0 << -1 << false << 0;
    QTest::newRow("with the tick of the end command") << -1 << 7 << false << 8;
    QTest::newRow("where the stop flag is up") << 12 << -1 << true << 0;
  }
  void a_run_ends() {
    QFETCH(int, ticks);
    QFETCH(int, end_at);
    QFETCH(bool, stopped);
    QFETCH(int, expected);
    ExecutorRig rig;
    rig.add("Puppet", "one");
    rig.wire();
    StopFlag stop;
    if (stopped) stop.raise();
    ExecutorOptions options{
        .ticks = ticks, .records = &rig.ring, .layout = rig.layout.get(), .stop = &stop};
    if (end_at >= 0) options.schedule = {{.kind = Command::Kind::end, .not_before = end_at}};
    Executor executor(rig.wired->main(), options);
    SimulatedClock clock;
    executor.run(clock);
    rig.drain();
    QCOMPARE(executor.statistics().ticks, std::int64_t{expected});
    QCOMPARE(rig.rows.size(), static_cast<std::size_t>(expected));
    compare(rig.told(), {"0 started", std::to_string(std::max(0, expected - 1)) + " ended"});
  }

  void statistics_count_every_slot_and_row() {
    ExecutorRig rig;
    rig.add("Puppet", "one");
    rig.wire();
    rig.start();
    rig.run(3);
    rig.skip(2);
    const LoopStatistics& loop = rig.executor->statistics();
    QCOMPARE(loop.ticks, std::int64_t{4});
    QCOMPARE(loop.skipped, std::int64_t{2});
    QCOMPARE(loop.rows, std::int64_t{4});
    QCOMPARE(loop.rows_lost, std::int64_t{0});
    QCOMPARE(loop.duration.count(), std::uint64_t{4});
    QCOMPARE(loop.lateness.count(), std::uint64_t{4});
    QCOMPARE(header_of(rig.rows.back()).tick, std::int64_t{5});
    QCOMPARE(header_of(rig.rows.back()).flags, std::int64_t{RowHeader::slots_skipped});
  }

  void in_real_time_the_loop_waits_for_no_reader() {
    ExecutorRig rig;
    rig.add("Puppet", "one");
    rig.wire();
    BroadcastRing tiny(1024, rig.layout->size());
    BroadcastRing::Cursor cursor(tiny, BroadcastRing::Cursor::Start::now,
                                 BroadcastRing::Cursor::Loss::never);
    Executor executor(rig.wired->main(), {.records = &tiny, .layout = rig.layout.get()});
    executor.start();
    for (std::int64_t i = 0; i < 100; ++i) executor.tick({i, 5, 0}, false);
    QCOMPARE(executor.statistics().rows, std::int64_t{100});
    QCOMPARE(executor.statistics().rows_lost, std::int64_t{0});
    QVERIFY(cursor.next()->missed > 0);
  }

  void rows_that_no_ring_takes_are_counted_and_the_loop_goes_on() {
    ExecutorRig rig;
    rig.add("Puppet", "one");
    rig.wire();
    BroadcastRing narrow(1024, rig.layout->size() - 1);
    Executor executor(rig.wired->main(), {.records = &narrow, .layout = rig.layout.get()});
    executor.start();
    for (std::int64_t i = 0; i < 100; ++i) executor.tick({i, 5, 0}, i % 2 == 0);
    QCOMPARE(executor.statistics().rows, std::int64_t{0});
    QVERIFY(executor.statistics().rows_lost >= 100);
    QCOMPARE(executor.statistics().ticks, std::int64_t{100});
  }

  void dates_stand_in_the_rows_of_real_time_only() {
    ExecutorRig rig;
    rig.add("Puppet", "one");
    rig.wire();
    rig.start();
    for (std::int64_t i = 0; i < 4; ++i) rig.executor->tick({i, 50, 0}, i >= 2);
    rig.drain();
    QCOMPARE(header_of(rig.rows[1]).lateness, std::int64_t{50});
    QVERIFY(header_of(rig.rows[1]).duration > 0);
    QCOMPARE(header_of(rig.rows[3]).lateness, std::int64_t{0});
    QCOMPARE(header_of(rig.rows[3]).duration, std::int64_t{0});
    QCOMPARE(number_at(rig.rows[3], sizeof(RowHeader)), 0.0);
  }

  void a_tick_allocates_nothing() {
    ArmRig rig;
    rig.get("rendering").law = [](Puppet& self, const Tick& tick) {
      *self.number = tick.index % 1000 == 500 ? not_a_number : 0.0;
    };
    std::vector<Command> edits;
    for (std::int64_t i = 0; i < 100; ++i)
      edits.push_back(rig.edit("gravity", "gain", static_cast<double>(i), 100 * i));
    rig.start({.timing = true, .schedule = edits});
    std::size_t records = 0;
    const int allocations = test::allocations_in([&] {
      for (int i = 0; i < 10'000; ++i) {
        if (i % 1000 == 900) rig.commands.try_push({.kind = Command::Kind::acknowledge});
        rig.executor->tick({rig.next++, 0, 0}, true);
        while (rig.cursor.next()) ++records;
      }
    });
    QCOMPARE(allocations, 0);
    QVERIFY(records > 10'100);
    QVERIFY(rig.executor->faults().size() >= 10);
  }
};

QTEST_APPLESS_MAIN(TestExecutor)
#include "tst_executor.moc"
