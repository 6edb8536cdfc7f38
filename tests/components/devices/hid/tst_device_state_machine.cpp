// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/device_state_machine.hpp"

#include <QTest>

#include "tests/support/allocation_counter.hpp"

using namespace trocar::hid;

namespace {

PerAxis<double> each(double value) {
  return {value, value, value, value, value, value};
}

const DeviceRules rules{.speed = each(1e6),
                        .calm_speed = each(1e4),
                        .calm_effort = each(164.0),
                        .homing_speed = each(1e4),
                        .homing_effort = {327, 327, 327, 491, 491, 491}};

/// Device and host at 1 kHz.
struct Bench {
  DeviceStateMachine device{rules};
  CommandIntake intake;
  DeviceInputs in;
  CommandReport command;
  bool host_alive = true;

  explicit Bench(std::uint32_t start_us = 0xFFFFFFFF - 700'000) {
    in.time_us = start_us;
    in.temperature.fill(65);
  }
  void ms(int count) {
    for (int i = 0; i < count; ++i) {
      in.time_us += 1000;
      if (host_alive) {
        ++command.sequence;
        command.deadline_us = in.time_us + 3000;
        Report report;
        encode(command, report);
        intake.take(report, in.time_us);
      }
      device.step(in, intake);
      in.found = 0;
    }
  }
  void ask(CommandMode mode) { command.mode = mode; }
  void home() {
    ask(CommandMode::home);
    ms(5);
    in.found = all_homed;
    ms(1);
  }
  void engage() {
    home();
    in.dead_man = true;
    command.hold.fill(1000);
    ask(CommandMode::render);
    ms(1600);
  }
  void acknowledge() {
    command.acknowledge = true;
    ms(1);
    command.acknowledge = false;
    ms(1);
  }
  int effort() const { return device.effort()[0]; }
};

}  // namespace

class TestDeviceStateMachine : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void not_homed_nothing_moves() {
    Bench bench;
    bench.command.hold.fill(1000);
    bench.command.effort.fill(100);
    bench.in.dead_man = true;
    for (const CommandMode mode : {CommandMode::off, CommandMode::hold, CommandMode::render}) {
      bench.ask(mode);
      bench.ms(2000);
      QCOMPARE(bench.device.state(), DeviceState::unhomed);
      QCOMPARE(bench.effort(), 0);
    }
  }

  void homing_is_weak_ignores_the_hosts_effort_and_ends_in_ready() {
    Bench bench;
    bench.command.hold.fill(1000);
    bench.ask(CommandMode::home);
    bench.in.homing_effort = {5000, -5000, 100, 5000, -5000, 0};
    bench.ms(5);
    QCOMPARE(bench.device.state(), DeviceState::homing);
    QVERIFY((bench.device.effort() == PerAxis<std::int16_t>{327, -327, 100, 491, -491, 0}));
    bench.in.found = 0x0F;
    bench.in.encoder.fill(123'456);  // set anew: no jump
    bench.in.encoder[4] = bench.in.encoder[5] = 0;
    bench.ms(1);
    QCOMPARE(bench.device.homed(), std::uint8_t(0x0F));
    QCOMPARE(bench.device.state(), DeviceState::homing);
    bench.in.found = 0x30;
    bench.ms(1);
    QCOMPARE(bench.device.state(), DeviceState::ready);
    QCOMPARE(bench.effort(), 0);
    bench.ms(100);  // the same request does not home twice
    QCOMPARE(bench.device.state(), DeviceState::ready);
  }

  void homing_ends_in_a_fault_data() {
    QTest::addColumn<int>("counts_per_ms");
    QTest::addColumn<int>("ms");
    QTest::addColumn<int>("fault");
    QTest::newRow("slow enough") << 10 << 200 << 0;
    QTest::newRow("too fast") << 11 << 200 << int(DeviceFault::homing);
    QTest::newRow("a jump") << 2002 << 10 << int(DeviceFault::encoder_jump);
    QTest::newRow("not found in 30 s") << 0 << 30'010 << int(DeviceFault::homing);
  }
  void homing_ends_in_a_fault() {
    QFETCH(int, counts_per_ms);
    QFETCH(int, ms);
    QFETCH(int, fault);
    Bench bench;
    bench.ask(CommandMode::home);
    bench.in.homing_effort.fill(300);
    for (int i = 0; i < ms; ++i) {
      bench.in.encoder[2] += counts_per_ms;
      bench.ms(1);
    }
    QCOMPARE(int(bench.device.fault()), fault);
    QCOMPARE(bench.effort(), fault == 0 ? 300 : 0);
    QCOMPARE(bench.device.homed(), std::uint8_t(0));
  }

  void leaving_the_mode_gives_homing_up() {
    Bench bench;
    bench.ask(CommandMode::home);
    bench.in.found = 0x01;
    bench.ms(2);
    bench.ask(CommandMode::hold);
    bench.ms(1);
    QCOMPARE(bench.device.state(), DeviceState::unhomed);
    QCOMPARE(bench.device.homed(), std::uint8_t(0));
  }

  void hold_then_calm_then_a_ramp() {
    Bench bench;
    bench.home();
    bench.in.dead_man = true;
    bench.command.hold.fill(1000);
    bench.command.effort.fill(100);
    bench.ask(CommandMode::render);
    bench.ms(1);
    QCOMPARE(bench.effort(), 1000);  // hold alone
    bench.ms(1498);                  // 1 s of hold, then 0.5 s of calm
    QCOMPARE(bench.device.state(), DeviceState::ready);
    bench.ms(1);
    QCOMPARE(bench.device.state(), DeviceState::engaged);
    QCOMPARE(bench.effort(), 1000);
    bench.ms(250);
    QCOMPARE(bench.effort(), 1050);
    bench.command.effort.fill(-10'000);
    bench.ms(250);
    QCOMPARE(bench.effort(), -9000);
  }

  void what_keeps_it_from_engaging_data() {
    QTest::addColumn<int>("what");
    QTest::newRow("nothing") << 0;
    QTest::newRow("no dead-man") << 1;
    QTest::newRow("not calm: moving") << 2;
    QTest::newRow("not calm: rendering") << 3;
    QTest::newRow("no request") << 4;
  }
  void what_keeps_it_from_engaging() {
    QFETCH(int, what);
    Bench bench;
    bench.home();
    bench.in.dead_man = what != 1;
    if (what == 3) bench.command.effort[5] = 165;
    bench.ask(what == 4 ? CommandMode::hold : CommandMode::render);
    for (int i = 0; i < 3000; ++i) {
      if (what == 2) bench.in.encoder[1] += 11;
      bench.ms(1);
    }
    QCOMPARE(bench.device.state(), what == 0 ? DeviceState::engaged : DeviceState::ready);
  }

  void a_moment_without_calm_starts_the_half_second_anew() {
    Bench bench;
    bench.home();
    bench.in.dead_man = true;
    bench.ask(CommandMode::render);
    bench.ms(1490);
    bench.command.effort[0] = 165;
    bench.ms(1);
    bench.command.effort[0] = 0;
    bench.ms(499);
    QCOMPARE(bench.device.state(), DeviceState::ready);
    bench.ms(1);
    QCOMPARE(bench.device.state(), DeviceState::engaged);
  }

  void releasing_the_dead_man_ends_rendering_at_once_and_asks_for_a_new_request() {
    Bench bench;
    bench.engage();
    bench.command.effort.fill(500);
    bench.ms(600);
    QCOMPARE(bench.effort(), 1500);
    bench.in.dead_man = false;
    bench.ms(1);
    QCOMPARE(bench.device.state(), DeviceState::ready);
    QCOMPARE(bench.effort(), 1000);
    bench.in.dead_man = true;
    bench.command.effort.fill(0);
    bench.ms(5000);
    QCOMPARE(bench.device.state(), DeviceState::ready);
    bench.ask(CommandMode::hold);
    bench.ms(1);
    bench.ask(CommandMode::render);
    bench.ms(510);
    QCOMPARE(bench.device.state(), DeviceState::engaged);
  }

  void the_firmware_zeroes_at_8_ms_without_a_valid_command() {
    Bench bench;
    bench.engage();
    bench.command.effort.fill(500);
    bench.ms(600);
    bench.host_alive = false;
    bench.ms(7);
    QCOMPARE(bench.effort(), 1500);
    bench.ms(1);
    QCOMPARE(bench.effort(), 0);
    QCOMPARE(bench.device.fault(), DeviceFault::watchdog);
    QCOMPARE(bench.device.homed(), all_homed);
    bench.host_alive = true;
    bench.ms(1000);
    QCOMPARE(bench.effort(), 0);  // latched
  }

  void silence_between_two_cycles_is_silence_too() {
    Bench bench;
    bench.engage();
    bench.in.time_us += 7000;  // and the next command is there before the next cycle
    bench.ms(1);
    QCOMPARE(bench.device.fault(), DeviceFault::watchdog);
    QCOMPARE(bench.effort(), 0);
  }

  void a_host_that_asked_for_nothing_may_leave() {
    Bench bench;
    bench.home();
    bench.ask(CommandMode::off);
    bench.ms(10);
    bench.host_alive = false;
    bench.ms(1000);
    QCOMPARE(bench.device.state(), DeviceState::ready);
  }

  void what_stays_after_a_fault_data() {
    QTest::addColumn<int>("fault");
    QTest::addColumn<int>("effort");
    QTest::addColumn<bool>("homed");
    QTest::newRow("jump: nothing") << int(DeviceFault::encoder_jump) << 0 << false;
    QTest::newRow("heat: hold") << int(DeviceFault::temperature) << 1000 << true;
    QTest::newRow("speed: hold") << int(DeviceFault::speed) << 1000 << true;
  }
  void what_stays_after_a_fault() {
    QFETCH(int, fault);
    QFETCH(int, effort);
    QFETCH(bool, homed);
    const auto cause = static_cast<DeviceFault>(fault);
    Bench bench;
    bench.engage();
    bench.command.effort.fill(100);
    for (int i = 0; i < 20; ++i) {
      if (cause == DeviceFault::encoder_jump) bench.in.encoder[3] += i == 5 ? 2002 : 0;
      if (cause == DeviceFault::temperature) bench.in.temperature[5] = 161;
      if (cause == DeviceFault::speed) bench.in.encoder[0] += 1001;
      bench.ms(1);
    }
    QCOMPARE(bench.device.fault(), cause);
    QCOMPARE(bench.effort(), effort);
    QCOMPARE(bench.device.homed() == all_homed, homed);

    bench.in.temperature.fill(65);
    bench.ms(1);
    bench.acknowledge();  // too early: the cause is gone for less than 0.1 s
    QCOMPARE(bench.device.state(), DeviceState::fault);
    bench.ms(150);
    bench.acknowledge();
    QCOMPARE(bench.device.state(), homed ? DeviceState::ready : DeviceState::unhomed);
    QCOMPARE(bench.device.fault(), DeviceFault::none);
    bench.command.effort.fill(0);
    bench.ms(5000);  // acknowledging never engages, though the dead-man is pressed
    QCOMPARE(bench.device.state(), homed ? DeviceState::ready : DeviceState::unhomed);
  }

  void a_request_made_during_a_fault_does_not_count() {
    Bench bench;
    bench.engage();
    bench.in.temperature[0] = 255;
    bench.ms(1);
    bench.in.temperature[0] = 65;
    bench.ask(CommandMode::hold);
    bench.ms(200);
    bench.ask(CommandMode::render);
    bench.ms(1);
    bench.acknowledge();
    bench.ms(5000);
    QCOMPARE(bench.device.state(), DeviceState::ready);
  }

  void an_acknowledge_that_is_always_set_does_not_count() {
    Bench bench;
    bench.engage();
    bench.command.acknowledge = true;
    bench.ms(10);
    bench.in.temperature[0] = 255;
    bench.ms(1);
    bench.in.temperature[0] = 65;
    bench.ms(1000);
    QCOMPARE(bench.device.state(), DeviceState::fault);
  }

  void hold_does_not_come_back_when_a_host_does_during_a_fault() {
    Bench bench;
    bench.engage();
    bench.in.temperature[0] = 255;
    bench.ms(5);
    QCOMPARE(bench.effort(), 1000);
    bench.host_alive = false;
    bench.ms(8);
    QCOMPARE(bench.effort(), 0);
    bench.host_alive = true;
    bench.ms(50);
    QCOMPARE(bench.effort(), 0);
    QCOMPARE(bench.device.fault(), DeviceFault::temperature);  // the first cause stays
  }

  void allocates_nothing() {
    Bench bench;
    bench.engage();
    QCOMPARE(trocar::test::allocations_in([&] { bench.ms(10); }), 0);
  }
};

QTEST_APPLESS_MAIN(TestDeviceStateMachine)
#include "tst_device_state_machine.moc"
