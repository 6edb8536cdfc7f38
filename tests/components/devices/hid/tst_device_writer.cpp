// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/device_writer.hpp"

#include <QTest>
#include <vector>

#include "tests/support/virtual_time.hpp"

using namespace trocar;
using namespace trocar::hid;

namespace {

/// Keeps what is written.
class Ear final : public Link {
 public:
  explicit Ear(std::vector<CommandReport>& heard) : heard_(heard) {}
  int read(std::span<std::uint8_t>, int) override { return 0; }
  bool write(ReportBytes report) override {
    CommandReport command;
    if (decode(report, command) == ReportDefect::none) heard_.push_back(command);
    return true;
  }

 private:
  std::vector<CommandReport>& heard_;
};

struct Bench {
  test::VirtualTime time;
  DeviceExchange exchange;
  DeviceWriter writer{time, exchange};
  std::vector<CommandReport> heard;

  Bench() {
    time.now_ns = 1'000'000'000;
    exchange.outlet.put(std::make_unique<Ear>(heard));
  }
  PostedCommand post(std::int64_t number, CommandMode mode = CommandMode::render) {
    PostedCommand posted{.number = number, .begun_ns = time.now_ns};
    posted.command.mode = mode;
    posted.command.deadline_us = static_cast<std::uint32_t>(time.now_ns / 1000) + 3000;
    posted.command.hold.fill(500);
    posted.command.effort.fill(100);
    posted.command.acknowledge = true;
    exchange.posted.store(posted);
    return posted;
  }
  WrittenCommand written() const {
    WrittenCommand result;
    exchange.written.load(result);
    return result;
  }
};

}  // namespace

class TestDeviceWriter : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void each_command_is_sent_once() {
    Bench bench;
    QVERIFY(!bench.writer.serve());
    for (std::int64_t n = 1; n <= 3; ++n) {
      bench.post(n);
      QVERIFY(bench.writer.serve());
      QVERIFY(!bench.writer.serve());
    }
    QCOMPARE(bench.heard.size(), std::size_t{3});
    QCOMPARE(bench.heard[2].sequence, std::uint16_t{3});
    QCOMPARE(bench.heard[2].effort[0], std::int16_t{100});
    QCOMPARE(bench.written().number, std::int64_t{3});
  }

  void a_hung_loop_gets_a_safe_command_in_its_place() {
    Bench bench;
    bench.post(1);
    bench.writer.serve();
    bench.time.now_ns += 5'000'000;
    bench.exchange.stalled_ns.store(bench.time.now_ns);
    QVERIFY(bench.writer.serve());
    QVERIFY(!bench.writer.serve());
    QCOMPARE(bench.heard.size(), std::size_t{2});
    const CommandReport& safe = bench.heard[1];
    QCOMPARE(safe.mode, CommandMode::hold);
    QCOMPARE(safe.hold[5], std::int16_t{500});
    QVERIFY(safe.effort == PerAxis<std::int16_t>{});
    QVERIFY(!safe.acknowledge);
    QCOMPARE(safe.deadline_us, bench.heard[0].deadline_us + 5000);
    QCOMPARE(safe.sequence, std::uint16_t{2});
  }

  void off_stays_off() {
    Bench bench;
    bench.post(1, CommandMode::off);
    bench.writer.serve();
    bench.exchange.stalled_ns.store(bench.time.now_ns + 1);
    bench.writer.serve();
    QCOMPARE(bench.heard[1].mode, CommandMode::off);
  }

  void homing_does_not_go_on_without_its_host() {
    Bench bench;
    bench.post(1, CommandMode::home);
    bench.writer.serve();
    bench.exchange.stalled_ns.store(bench.time.now_ns + 1);
    bench.writer.serve();
    QCOMPARE(bench.heard[1].mode, CommandMode::hold);
  }

  void the_command_of_the_tick_that_hung_is_dropped() {
    Bench bench;
    bench.post(1);
    bench.writer.serve();
    bench.time.now_ns += 1'000'000;
    const PostedCommand hung = bench.post(2);
    bench.exchange.posted.store(hung);
    bench.time.now_ns += 5'000'000;
    bench.exchange.stalled_ns.store(bench.time.now_ns);
    bench.writer.serve();  // safe, from what was posted last
    PostedCommand late = hung;
    late.number = 3;
    bench.exchange.posted.store(late);
    QVERIFY(bench.writer.serve());
    QCOMPARE(bench.heard.size(), std::size_t{2});
    QCOMPARE(bench.written().dropped, std::int64_t{1});
    bench.time.now_ns += 1'000'000;
    bench.post(4);
    bench.writer.serve();
    QCOMPARE(bench.heard.size(), std::size_t{3});
  }

  void without_a_command_there_is_nothing_to_make_safe() {
    Bench bench;
    bench.exchange.stalled_ns.store(5);
    QVERIFY(!bench.writer.serve());
    QVERIFY(bench.heard.empty());
  }
};

QTEST_APPLESS_MAIN(TestDeviceWriter)
#include "tst_device_writer.moc"
