// SPDX-License-Identifier: Apache-2.0
#include "framework/gate.hpp"

#include <QTest>
#include <bit>
#include <limits>
#include <memory>
#include <random>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/gate_rig.hpp"

using namespace trocar;
using trocar::test::GateRig;
using trocar::test::TestDevice;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Nobody but the gate makes gated effort, nor copies, moves or forges it.
static_assert(!std::is_default_constructible_v<GatedEffort>);
static_assert(!std::is_constructible_v<GatedEffort, const Joints&, std::int64_t, std::int64_t>);
static_assert(!std::is_copy_constructible_v<GatedEffort> &&
              !std::is_move_constructible_v<GatedEffort>);
static_assert(!std::is_copy_assignable_v<GatedEffort> && !std::is_move_assignable_v<GatedEffort>);
static_assert(!std::is_trivially_copyable_v<GatedEffort>, "std::bit_cast could make one");
static_assert(!std::is_aggregate_v<GatedEffort>);

template <typename T>
concept writable = requires(T& device, const Tick& tick, const GatedEffort& effort) {
  device.write(tick, effort);
};
template <typename T>
concept tells_status = requires(const T& device) {
  device.status();
};
template <typename T>
concept tells_loads = requires(const T& device, ToolLoads& loads) {
  device.tool_loads(Joints{}, loads);
};
template <typename T>
concept tells_speed = requires(const T& device) {
  device.handle_speed(Joints{});
};
static_assert(!writable<Device> && !writable<TestDevice>);
static_assert(!tells_status<Device> && !tells_loads<Device> && !tells_speed<Device>);

/// The same questions asked from inside a component, which has no more rights.
struct Intruder : Component {
  template <typename T>
  static constexpr bool can_write = requires(T& device, const Tick& tick, const GatedEffort& e) {
    device.write(tick, e);
  };
  template <typename T>
  static constexpr bool can_make = requires {
    T(Joints{}, std::int64_t{}, std::int64_t{});
  };
};
static_assert(!Intruder::can_write<Device> && !Intruder::can_write<TestDevice>);
static_assert(!Intruder::can_make<GatedEffort>);

/// And from inside another device.
struct OtherDevice : Device {
  template <typename T>
  static constexpr bool can_write = requires(T& device, const Tick& tick, const GatedEffort& e) {
    device.write(tick, e);
  };
};
static_assert(!OtherDevice::can_write<TestDevice>);

Joints joints(double a, double b, double c) {
  Joints result;
  result[0] = a;
  result[1] = b;
  result[2] = c;
  return result;
}

const Fault* fault_of(const FaultLatch& faults, FaultCause cause) {
  for (std::size_t i = 0; i < faults.size(); ++i)
    if (faults[i].cause == cause) return &faults[i];
  return nullptr;
}

/// Things that go wrong, by a name that a table can hold.
void break_it(GateRig& rig, const QString& what) {
  if (what == "effort nan") rig.effort[1] = not_a_number;
  if (what == "effort inf") rig.effort[1] = infinity;
  if (what == "raw wrench") rig.effort[2] = 60.0;
  if (what == "hold nan") rig.hold[0] = not_a_number;
  if (what == "hold limit") rig.hold[1] = -12.5;
  if (what == "position nan") rig.position[2] = not_a_number;
  if (what == "report invalid") {
    rig.device.report.position_valid = false;
    rig.device.report.why = "no report for 6 ms";
  }
  if (what == "homing lost") rig.device.report.homed = false;
  if (what == "jump") rig.position[0] += 0.02;
  if (what == "workspace") rig.position[0] = 0.107;
}

}  // namespace

class TestGate : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_command_is_sent_once_with_its_tick_and_a_deadline_of_three_periods() {
    GateRig rig;
    rig.gate();
    rig.pass(5);
    QCOMPARE(rig.device.writes, 5);
    QCOMPARE(rig.device.written_tick, std::int64_t{4});
    QCOMPARE(rig.device.written_deadline, std::int64_t{7'000'000});
  }

  void the_order_of_the_checks_data() {
    QTest::addColumn<double>("effort");  // [N] on axis 3, where handle force equals effort
    QTest::addColumn<double>("cap");     // [N]
    QTest::addColumn<double>("rise");    // [N/s]
    QTest::addColumn<double>("expected");
    QTest::addColumn<QString>("state");
    QTest::newRow("nothing binds") << 0.5 << 20.0 << 1000.0 << 0.5 << "engaged";
    QTest::newRow("the actuator limit binds after hold")
        << 30.0 << 50.0 << 1e6 << 10.0 << "engaged";
    QTest::newRow("the cap binds") << 30.0 << 4.0 << 1e6 << 4.0 << "engaged";
    QTest::newRow("the rise binds what the cap left") << 30.0 << 4.0 << 1000.0 << 1.0 << "engaged";
    QTest::newRow("a raw wrench trips, though the cap would have tamed it")
        << 45.0 << 4.0 << 1000.0 << 0.0 << "tripped";
  }
  void the_order_of_the_checks() {
    QFETCH(double, effort);
    QFETCH(double, cap);
    QFETCH(double, rise);
    QFETCH(double, expected);
    QFETCH(QString, state);
    GateRig rig;
    rig.device.cap = cap;
    rig.device.load_trip = 40.0;
    rig.device.declared.rise[2] = rise;
    rig.hold[2] = 2.0;
    rig.gate();
    rig.pass();
    rig.effort[2] = effort;
    rig.pass();
    QVERIFY(std::abs(rig.sent(2) - 2.0 - expected) < 1e-12);
    QCOMPARE(QString(to_string(rig.gate().state())), state);
    QVERIFY(std::abs(*rig.device.scale - expected / effort) < 1e-12);
    QCOMPARE((*rig.device.effort_sent)[2], rig.sent(2));
  }

  void saturation_keeps_the_direction_and_every_limit() {
    std::mt19937_64 random(20);
    const auto uniform = [&](double a, double b) {
      return std::uniform_real_distribution<double>(a, b)(random);
    };
    GateRig rig;
    rig.device.cap = 15.0;
    rig.gate();
    const DeviceLimits& limits = rig.device.declared;
    Joints before{};
    int saturated = 0;
    for (int tick = 0; tick < 20000; ++tick) {
      const double size = std::pow(10.0, uniform(-3.0, 4.0));
      for (int i = 0; i < 3; ++i) {
        rig.hold[i] = uniform(-12.0, 12.0);
        rig.effort[i] = uniform(-size, size);
      }
      rig.pass();
      QCOMPARE(rig.gate().state(), Gate::State::engaged);
      const double s = *rig.device.scale;
      QVERIFY(s >= 0.0 && s <= 1.0);
      saturated += s < 1.0;
      Joints rendered{};
      bool binding = s == 1.0;
      for (int i = 0; i < 3; ++i) {
        rendered[i] = rig.sent(i) - rig.hold[i];
        QVERIFY(std::abs(rendered[i] - s * rig.effort[i]) < 1e-11);
        QVERIFY(std::abs(rig.sent(i)) <= limits.effort[i]);
        const bool same = rig.effort[i] * before[i] > 0.0;
        const double reachable = (same ? std::abs(before[i]) : 0.0) + limits.rise[i] * rig.period;
        QVERIFY(std::abs(rendered[i]) <= reachable + 1e-9);
        binding = binding || std::abs(rig.sent(i)) > limits.effort[i] - 1e-9 ||
                  std::abs(rendered[i]) > reachable - 1e-9;
      }
      const double handle = TestDevice::handle_force(rendered).norm();
      QVERIFY(handle <= rig.device.cap + 1e-9);
      QVERIFY2(binding || handle > rig.device.cap - 1e-9, "a larger scale was possible");
      before = rendered;
    }
    QVERIFY(saturated > 5000 && saturated < 19000);
  }

  void rising_is_limited_by_one_factor_and_falling_is_not() {
    GateRig rig;
    rig.gate();
    rig.effort = joints(8.0, 0.8, -0.4);
    for (int k = 1; k <= 8; ++k) {
      rig.pass();
      QVERIFY(std::abs(rig.sent(0) - k) < 1e-12);
      QVERIFY(std::abs(rig.sent(1) - 0.1 * k) < 1e-12);
      QVERIFY(std::abs(rig.sent(2) + 0.05 * k) < 1e-12);
    }
    rig.effort = joints(0.5, 0.05, -0.025);
    rig.pass();
    QCOMPARE(rig.sent(0), 0.5);
    rig.effort = joints(-8.0, 0.0, 0.0);
    rig.pass();
    QVERIFY2(std::abs(rig.sent(0) + 1.0) < 1e-12, "a new sign rises from zero");
  }

  void a_trip_names_cause_component_tick_value_and_limit_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<int>("cause");
    QTest::addColumn<QString>("detail");
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("limit");
    using enum FaultCause;
    const auto row = [](const char* name, const char* what, FaultCause cause, const char* detail,
                        double value, double limit) {
      QTest::newRow(name) << what << static_cast<int>(cause) << detail << value << limit;
    };
    row("NaN in effort", "effort nan", not_finite, "effort", 0, 0);
    row("infinite effort", "effort inf", not_finite, "effort", 0, 0);
    row("raw wrench beyond its trip", "raw wrench", handle_wrench, "handle force", 60, 40);
    row("NaN in hold", "hold nan", not_finite, "hold", 0, 0);
    row("hold beyond an actuator", "hold limit", hold_beyond_limit, "hold", 12.5, 12);
    row("NaN in the report", "position nan", position_lost, "not finite", 0, 0);
    row("report not valid", "report invalid", position_lost, "no report for 6 ms", 0, 0);
    row("homing lost", "homing lost", position_lost, "not homed", 0, 0);
    row("encoder jump", "jump", encoder_jump, "between two reports", 0.02, 0.01);
    row("beyond the workspace", "workspace", workspace, "axis beyond its range", 0.007, 0.005);
  }
  void a_trip_names_cause_component_tick_value_and_limit() {
    QFETCH(QString, what);
    QFETCH(int, cause);
    QFETCH(QString, detail);
    QFETCH(double, value);
    QFETCH(double, limit);
    GateRig rig;
    rig.device.load_trip = 40.0;
    if (what == "workspace") rig.position[0] = 0.104;
    rig.gate();
    rig.pass(10);
    QVERIFY(!rig.faults.latched());
    break_it(rig, what);
    rig.pass();
    QCOMPARE(rig.gate().state(), Gate::State::tripped);
    QVERIFY(rig.faults.latched());
    const Fault& first = rig.faults[0];
    QCOMPARE(static_cast<int>(first.cause), cause);
    QCOMPARE(QString(first.component), QString("arm"));
    QCOMPARE(QString(first.detail), detail);
    QCOMPARE(first.tick, std::int64_t{10});
    QCOMPARE(first.time_ns, std::int64_t{10'000'000});
    QVERIFY(std::abs(first.value - value) < 1e-12);
    QVERIFY(std::abs(first.limit - limit) < 1e-12);
    rig.pass(50);
    QCOMPARE(rig.faults[0].tick, std::int64_t{10});
  }

  void what_stays_after_a_trip_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<bool>("hold_stays");
    QTest::addColumn<bool>("damping_stays");
    QTest::newRow("NaN in effort") << "effort nan" << true << true;
    QTest::newRow("raw wrench") << "raw wrench" << true << true;
    QTest::newRow("operator") << "operator" << true << true;
    QTest::newRow("effort computed from a value that is not finite")
        << "unusable effort" << true << true;
    QTest::newRow("NaN in hold") << "hold nan" << false << false;
    QTest::newRow("hold beyond its limit") << "hold limit" << false << false;
    QTest::newRow("hold computed from a value that is not finite")
        << "unusable hold" << false << false;
    QTest::newRow("NaN in the report") << "position nan" << false << false;
    QTest::newRow("stale report") << "report invalid" << false << false;
    QTest::newRow("encoder jump") << "jump" << false << false;
    QTest::newRow("homing lost") << "homing lost" << false << false;
  }
  void what_stays_after_a_trip() {
    QFETCH(QString, what);
    QFETCH(bool, hold_stays);
    QFETCH(bool, damping_stays);
    GateRig rig;
    rig.device.load_trip = 40.0;
    rig.gate();
    rig.hold = joints(5.0, -3.0, 1.0);
    rig.effort = joints(2.0, 2.0, 2.0);
    const auto moving = [&](int ticks, bool effort_usable = true, bool hold_usable = true) {
      for (int i = 0; i < ticks; ++i) {
        rig.position[2] += 1e-4;  // 0.1 m/s
        rig.pass(1, effort_usable, hold_usable);
      }
    };
    moving(20);
    QCOMPARE(rig.sent(0), 7.0);
    QVERIFY(!rig.faults.latched());
    break_it(rig, what);
    if (what == "operator") rig.gate().stop_rendering({.cause = FaultCause::operator_stop});
    moving(1, what != "unusable effort", what != "unusable hold");
    const auto check = [&] {
      const double damping = damping_stays ? -0.5 : 0.0;
      QCOMPARE(rig.gate().state(), Gate::State::tripped);
      QCOMPARE(*rig.device.scale, 0.0);
      QCOMPARE(rig.sent(0), hold_stays ? 5.0 : 0.0);
      QCOMPARE(rig.sent(1), hold_stays ? -3.0 : 0.0);
      QVERIFY(std::abs(rig.sent(2) - (hold_stays ? 1.0 : 0.0) - damping) < 1e-9);
    };
    check();
    rig.hold = joints(5.0, -3.0, 1.0);  // a trip latches even where the cause passes
    rig.effort = joints(2.0, 2.0, 2.0);
    moving(300);
    check();
  }

  void hold_must_be_the_devices_weight() {
    GateRig rig;
    for (int i = 0; i < 3; ++i) rig.device.declared.hold_tolerance[i] = 0.5;
    rig.device.own_weight = joints(5.0, 0.0, 0.0);
    rig.gate();
    rig.hold = joints(5.4, -0.4, 0.0);
    rig.pass(5);
    QVERIFY(!rig.faults.latched());
    rig.hold = joints(5.4, -0.6, 0.0);  // a force that somebody renders through hold
    rig.pass();
    QCOMPARE(rig.faults[0].cause, FaultCause::hold_beyond_limit);
    QCOMPARE(rig.faults[0].limit, 0.5);
    QVERIFY(std::abs(rig.faults[0].value - 0.6) < 1e-12);
    for (int i = 0; i < 3; ++i) QCOMPARE(rig.sent(i), 0.0);
  }

  void a_device_has_one_gate() {
    GateRig rig;
    rig.gate();
    QVERIFY_THROWS_EXCEPTION(std::logic_error,
                             std::make_unique<Gate>(rig.device, GateRig::period, rig.faults));
  }

  void skipped_slots_are_no_encoder_jump() {
    GateRig rig;
    rig.gate();
    rig.hold = joints(5.0, 0.0, 0.0);
    const auto move = [&](int periods) {  // at 0.5 m/s
      rig.tick += periods - 1;
      rig.position[2] += 0.5e-3 * periods;
      rig.pass();
    };
    for (int i = 0; i < 10; ++i) move(1);
    move(21);  // 10.5 mm, more than the 10 mm that one period allows
    QVERIFY(!rig.faults.latched());
    QVERIFY(std::abs(rig.gate().velocity()[2] - 0.5) < 1e-9);
    move(60);  // longer than rendering may go without a tick
    QCOMPARE(rig.faults[0].cause, FaultCause::overload);
    QCOMPARE(rig.sent(0), 5.0);
  }

  void damping_is_capped_and_never_pushes_along_the_motion() {
    GateRig rig;
    rig.gate();
    rig.pass();
    rig.gate().stop_rendering({.cause = FaultCause::operator_stop});
    for (int i = 0; i < 20; ++i) {
      rig.position = joints(rig.position[0] + 6e-4, rig.position[1] - 2e-4, 0.0);
      rig.pass();
    }
    QVERIFY2(std::abs(rig.sent(0) + 2.0) < 1e-9, "0.6 m/s would be 3 N, the cap is 2 N");
    QVERIFY(std::abs(rig.sent(1) - 1.0) < 1e-9);
    QCOMPARE(rig.sent(2), 0.0);
  }

  void speed_trips_at_the_handle_and_at_an_axis() {
    for (const double limit : {0.8, 5.0}) {
      GateRig rig;
      rig.device.declared.handle_speed = limit;
      rig.gate();
      rig.pass();
      for (int i = 0; i < 10 && !rig.faults.latched(); ++i) {
        rig.position[0] += 2e-3;
        rig.pass();
      }
      QVERIFY(rig.faults.latched());
      QCOMPARE(rig.faults[0].cause, FaultCause::speed);
      QCOMPARE(QString(rig.faults[0].detail), QString(limit < 1.0 ? "handle" : "axis"));
      QCOMPARE(rig.faults[0].limit, limit < 1.0 ? 0.8 : 1.0);
      QVERIFY(rig.faults[0].value > rig.faults[0].limit);
    }
  }

  void more_tool_loads_than_fit_trip_instead_of_going_unwatched() {
    GateRig rig;
    rig.device.loads = 9;
    rig.gate();
    rig.pass();
    QCOMPARE(rig.gate().state(), Gate::State::tripped);
    QCOMPARE(QString(rig.faults[0].detail), QString("more tool loads than fit"));
  }

  void engaging_from_cold_takes_the_hold_the_calm_and_the_ramp() {
    GateRig rig;
    rig.device.engaged_at_start = false;
    rig.hold = joints(10.0, 0.0, 0.0);
    rig.effort = joints(0.0, 0.0, 0.8);
    rig.gate().request_engage();
    for (int k = 1; k <= 1000; ++k) {
      rig.pass();
      QVERIFY(std::abs(rig.sent(0) - 0.01 * k) < 1e-9);
      QCOMPARE(rig.sent(2), 0.0);
    }
    const std::int64_t held = rig.tick;
    while (rig.gate().state() != Gate::State::engaging && rig.tick < 3000) rig.pass();
    QVERIFY(std::abs(static_cast<double>(rig.tick - held) - 500.0) <= 2.0);
    QCOMPARE(rig.sent(0), 10.0);
    double before = 0.0;
    const std::int64_t ramp = rig.tick;
    while (rig.gate().state() == Gate::State::engaging && rig.tick < 5000) {
      rig.pass();
      QVERIFY(rig.sent(2) >= before && rig.sent(2) - before < 0.8 * 0.002 + 1e-9);
      before = rig.sent(2);
    }
    QVERIFY(std::abs(static_cast<double>(rig.tick - ramp) - 500.0) <= 2.0);
    QCOMPARE(rig.gate().state(), Gate::State::engaged);
    QCOMPARE(rig.sent(2), 0.8);
  }

  void what_keeps_it_from_engaging_data() {
    QTest::addColumn<QString>("what");
    for (const char* what : {"no request", "not homed", "dead-man released", "handle moves",
                             "rendered force of 1 N", "tripped"})
      QTest::newRow(what) << what;
  }
  void what_keeps_it_from_engaging() {
    QFETCH(QString, what);
    GateRig rig;
    rig.device.engaged_at_start = false;
    rig.device.report.homed = what != "not homed";
    rig.device.report.dead_man = what != "dead-man released";
    rig.effort[2] = what == "rendered force of 1 N" ? 1.0 : 0.99;
    rig.gate();
    if (what == "tripped") rig.gate().stop_rendering({.cause = FaultCause::operator_stop});
    for (int i = 0; i < 4000; ++i) {
      if (what != "no request") rig.gate().request_engage();
      if (what == "handle moves") rig.position[0] += i / 500 % 2 == 0 ? 3e-5 : -3e-5;
      rig.pass();
      QCOMPARE(rig.sent(2), 0.0);
      QVERIFY(rig.gate().state() != Gate::State::engaged);
    }
  }

  void a_moment_without_calm_starts_the_half_second_anew() {
    GateRig rig;
    rig.device.engaged_at_start = false;
    rig.gate().request_engage();
    rig.pass(1400);
    rig.device.report.dead_man = false;
    rig.pass();
    rig.device.report.dead_man = true;
    rig.pass(490);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    rig.pass(20);
    QCOMPARE(rig.gate().state(), Gate::State::engaging);
  }

  void releasing_the_dead_man_ends_rendering_at_once_and_asks_for_a_new_request() {
    GateRig rig;
    rig.gate();
    rig.hold[0] = 3.0;
    rig.effort[2] = 0.9;
    rig.pass();
    QCOMPARE(rig.sent(2), 0.9);
    rig.device.report.dead_man = false;
    rig.pass();
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    QCOMPARE(rig.sent(2), 0.0);
    QCOMPARE(rig.sent(0), 3.0);
    rig.device.report.dead_man = true;
    rig.pass(2000);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    rig.gate().request_engage();
    rig.pass();
    QCOMPARE(rig.gate().state(), Gate::State::engaging);
    rig.pass(100);
    QVERIFY2(std::abs(rig.sent(2) - 0.2 * 0.9) < 1e-9, "the ramp starts anew");
    rig.device.report.dead_man = false;
    rig.pass();
    QVERIFY2(rig.sent(2) == 0.0, "also during the ramp");
  }

  void acknowledging_waits_until_the_cause_has_gone() {
    for (const char* what : {"effort nan", "raw wrench", "hold nan", "hold limit", "position nan",
                             "report invalid", "homing lost", "workspace"}) {
      GateRig rig;
      rig.device.load_trip = 40.0;
      rig.position[0] = 0.104;
      rig.gate();
      rig.pass(10);
      break_it(rig, what);
      rig.pass(200);
      QVERIFY2(!rig.gate().acknowledge(), what);
      rig.effort = rig.hold = {};
      rig.position = joints(0.104, 0.0, 0.0);
      rig.device.report = {};
      rig.pass(50);
      QVERIFY2(!rig.gate().acknowledge(), what);
      rig.pass(100);
      QVERIFY2(rig.gate().acknowledge(), what);
      QCOMPARE(rig.gate().state(), Gate::State::cold);
      QVERIFY2(!rig.gate().acknowledge(), "nothing is left to acknowledge");
    }
  }

  void acknowledging_never_engages() {
    GateRig rig;
    rig.gate();
    rig.pass(10);
    rig.gate().stop_rendering({.cause = FaultCause::operator_stop});
    rig.pass(200);
    rig.gate().request_engage();  // before the acknowledgement: does not count
    QVERIFY(rig.gate().acknowledge());
    rig.pass(3000);
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    rig.gate().request_engage();
    rig.pass(600);
    QCOMPARE(rig.gate().state(), Gate::State::engaged);
  }

  void after_an_acknowledgement_hold_stays_where_it_stayed_and_ramps_where_it_was_lost() {
    for (const bool lost : {false, true}) {
      GateRig rig;
      rig.gate();
      rig.hold[0] = 10.0;
      rig.pass(10);
      if (lost) rig.device.report.position_valid = false;
      rig.gate().stop_rendering({.cause = FaultCause::operator_stop});
      rig.pass();
      rig.device.report.position_valid = true;
      rig.pass(200);
      QVERIFY(rig.gate().acknowledge());
      rig.pass();
      QVERIFY(std::abs(rig.sent(0) - (lost ? 0.01 : 10.0)) < 1e-9);
    }
  }

  void homing_may_step_the_position_and_sends_nothing() {
    GateRig rig;
    rig.device.engaged_at_start = false;
    rig.device.report.homed = false;
    rig.hold[0] = 5.0;
    rig.gate();
    rig.position[0] = -3.0;  // whatever an encoder says before
    for (int i = 0; i < 100; ++i) {
      rig.position[0] += 1e-3;
      rig.pass();
      QCOMPARE(rig.sent(0), 0.0);
    }
    rig.device.report.homed = true;
    rig.position[0] = 0.05;
    rig.pass(1001);
    QVERIFY(!rig.faults.latched());
    QCOMPARE(rig.gate().state(), Gate::State::holding);
    QCOMPARE(rig.sent(0), 5.0);
  }

  void homing_lost_while_cold_and_moving_leaves_no_stale_damping() {
    GateRig rig;
    rig.device.engaged_at_start = false;
    rig.gate();
    for (int i = 0; i < 10; ++i) {
      rig.position[0] += 1e-4;
      rig.pass();
    }
    QVERIFY(rig.sent(0) < -0.1);
    rig.device.report.homed = false;
    rig.pass();
    QCOMPARE(rig.gate().state(), Gate::State::cold);
    QCOMPARE(rig.sent(0), 0.0);
  }

  void a_report_that_comes_back_elsewhere_is_no_second_fault() {
    GateRig rig;
    rig.gate();
    rig.pass(10);
    rig.device.report.position_valid = false;
    rig.pass(20);
    rig.device.report.position_valid = true;
    rig.position[1] = 0.05;
    rig.pass();
    QCOMPARE(rig.faults.size(), std::size_t{1});
    QCOMPARE(rig.sent(0), 0.0);
  }

  void a_device_that_starts_engaged_holds_fully_and_renders_without_a_jump() {
    GateRig rig;
    rig.hold[0] = 10.0;
    rig.effort[1] = 3.0;
    rig.gate();
    rig.pass();
    QCOMPARE(rig.gate().state(), Gate::State::engaged);
    QCOMPARE(rig.sent(0), 10.0);
    QVERIFY(std::abs(rig.sent(1) - 1.0) < 1e-12);
  }

  void whatever_comes_in_what_goes_out_is_finite_and_within_limits() {
    std::mt19937_64 random(7);
    GateRig rig;
    rig.device.load_trip = 40.0;
    rig.gate();
    const double odd[] = {0.0,   -0.0,   1.0,          -11.9,    13.0,     1e-310,
                          1e308, -1e308, not_a_number, infinity, -infinity};
    for (int tick = 0; tick < 50000; ++tick) {
      const auto pick = [&] { return random() % 4 == 0 ? odd[random() % std::size(odd)] : 0.5; };
      for (int i = 0; i < 3; ++i) {
        rig.hold[i] = pick();
        rig.effort[i] = pick();
        rig.position[i] = random() % 50 == 0 ? pick() : 0.0;
      }
      rig.device.report.position_valid = random() % 50 != 0;
      rig.device.report.dead_man = random() % 50 != 0;
      rig.device.report.homed = random() % 50 != 0;
      if (random() % 9 == 0) rig.gate().request_engage();
      if (random() % 9 == 0) rig.gate().acknowledge();
      rig.pass(1, random() % 50 != 0, random() % 50 != 0);
      for (int i = 0; i < max_axes; ++i) QVERIFY(std::abs(rig.sent(i)) <= (i < 3 ? 12.0 : 0.0));
    }
  }

  void pass_does_not_allocate_in_any_state() {
    GateRig rig;
    rig.device.engaged_at_start = false;
    rig.device.load_trip = 40.0;
    rig.hold[0] = 1.0;
    rig.gate();
    int states = 0;
    const int n = test::allocations_in([&] {
      const auto see = [&](int ticks) {
        rig.pass(ticks);
        states |= 1 << static_cast<int>(rig.gate().state());
      };
      see(1);     // cold
      see(1100);  // holding
      rig.gate().request_engage();
      see(500);  // engaging
      see(600);  // engaged
      rig.effort[0] = not_a_number;
      rig.hold[0] = 50.0;
      rig.position[0] = 0.5;
      see(200);  // tripped
      rig.gate().acknowledge();
    });
    QCOMPARE(n, 0);
    QCOMPARE(states, 0b11111);
    QVERIFY(fault_of(rig.faults, FaultCause::workspace) != nullptr);
    QVERIFY2(test::allocations_in([] {
               const std::vector<double> seen(7, 1.0);
               [[maybe_unused]] volatile double sink = seen[3];
             }) > 0,
             "the counter counts");
  }
};

QTEST_APPLESS_MAIN(TestGate)
#include "tst_gate.moc"
