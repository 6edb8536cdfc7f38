// SPDX-License-Identifier: Apache-2.0
// The two threads of a driver, with a device that has a thread as well.
#include "components/devices/hid/device_line.hpp"

#include <QTest>
#include <atomic>
#include <chrono>
#include <thread>

#include "components/devices/hid/emulated_laparoscope.hpp"
#include "components/devices/hid/pipe_link.hpp"

using namespace trocar;
using namespace trocar::hid;

namespace {

/// Until it holds, or a machine that is very slow had its chance.
template <typename Condition>
bool comes(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!condition() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  return condition();
}

/// An emulated device on a thread of its own, which goes on as it is read.
class DeviceThread {
 public:
  ~DeviceThread() {
    stop_.raise();
    thread_.join();
  }
  void plug(std::unique_ptr<PipeLink> end) { ends_.put(std::move(end)); }
  void unplug() { unplug_ = true; }

  std::atomic<int> commands{0}, torn{0}, out_of_order{0}, safe{0};
  std::atomic<unsigned> tick{0};

 private:
  void run() {
    std::unique_ptr<PipeLink> end;
    while (!stop_.raised()) {
      if (auto next = ends_.take()) end = std::move(*next);
      if (unplug_.exchange(false)) end.reset();
      if (end == nullptr) {
        std::this_thread::yield();
        continue;
      }
      std::array<std::uint8_t, 100> bytes{};
      const int size = end->read(bytes, 1);
      if (size > 0) take(ReportBytes(bytes.data(), static_cast<std::size_t>(size)));
      for (int i = 0; i < 4; ++i) device_.cycle();
      Report report;
      while (device_.next(report)) end->write(report);
    }
  }
  void take(ReportBytes bytes) {
    device_.receive(bytes);
    CommandReport command;
    if (decode(bytes, command) != ReportDefect::none) return;
    ++commands;
    if (command.sequence != static_cast<std::uint16_t>(last_.sequence + 1)) ++out_of_order;
    const auto value = static_cast<std::int16_t>(command.tick & 0x3FFF);
    for (std::size_t i = 0; i < axes; ++i) {
      if (command.hold[i] != value) ++torn;
      if (command.effort[i] != (command.mode == CommandMode::render ? -value : 0)) ++torn;
    }
    if (command.mode == CommandMode::hold) ++safe;
    last_ = command;
    tick = command.tick;
  }

  EmulatedLaparoscope device_;
  CommandReport last_;
  Handover<std::unique_ptr<PipeLink>> ends_;
  std::atomic<bool> unplug_{false};
  StopFlag stop_;
  std::thread thread_{[this] { run(); }};
};

class ThreadSource final : public LinkSource {
 public:
  explicit ThreadSource(DeviceThread& device) : device_(device) {}
  LinkPair open() override {
    auto [host, other] = PipeLink::make_pair();
    device_.plug(std::move(other));
    auto second = host->second();
    return {std::move(host), std::move(second)};
  }

 private:
  DeviceThread& device_;
};

/// The device's time goes as it is read, so no report is too old here.
DeviceLineSettings settings() {
  return {.name = "test", .oldest_ns = 1'000'000'000'000};
}

PostedCommand numbered(std::int64_t number, const DeviceLine& line) {
  PostedCommand posted{.number = number, .begun_ns = line.now()};
  posted.command.mode = CommandMode::render;
  posted.command.tick = static_cast<std::uint32_t>(number);
  const auto value = static_cast<std::int16_t>(number & 0x3FFF);
  posted.command.hold.fill(value);
  posted.command.effort.fill(static_cast<std::int16_t>(-value));
  return posted;
}

}  // namespace

class TestDeviceLine : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void reports_and_commands_cross_whole_and_in_order() {
    DeviceThread device;
    DeviceLine line(std::make_unique<ThreadSource>(device), time_, settings());
    QCOMPARE(line.open().identity.serial, 1u);
    line.start();
    std::int64_t received = 0;
    for (std::int64_t n = 1; n <= 300; ++n) {
      line.post(numbered(n, line));
      QVERIFY(comes([&] { return device.tick == static_cast<unsigned>(n); }));
      const DeviceSnapshot& snapshot = line.snapshot();
      QVERIFY(snapshot.connected && snapshot.any);
      QVERIFY(snapshot.received >= received);
      received = snapshot.received;
    }
    QVERIFY(comes([&] { return line.written().number == 300; }));
    QCOMPARE(line.written().written, std::int64_t{300});
    QVERIFY(comes([&] { return line.snapshot().received > received; }));
    QCOMPARE(device.torn.load(), 0);
    QCOMPARE(device.out_of_order.load(), 0);
    QCOMPARE(line.snapshot().refused, std::int64_t{0});
  }

  void of_commands_that_come_too_fast_the_newest_is_sent_once() {
    DeviceThread device;
    DeviceLine line(std::make_unique<ThreadSource>(device), time_, settings());
    line.open();
    line.start();
    for (std::int64_t n = 1; n <= 100'000; ++n) line.post(numbered(n, line));
    QVERIFY(comes([&] { return device.tick == 100'000u; }));
    line.stop();
    QCOMPARE(device.torn.load(), 0);
    QCOMPARE(device.out_of_order.load(), 0);
    QCOMPARE(line.written().written, std::int64_t{device.commands.load()});
  }

  void the_supervisor_has_a_safe_command_sent() {
    DeviceThread device;
    DeviceLine line(std::make_unique<ThreadSource>(device), time_, settings());
    line.open();
    line.start();
    line.post(numbered(1, line));
    QVERIFY(comes([&] { return device.tick == 1u; }));
    const PostedCommand hung = numbered(2, line);
    std::thread supervisor([&] { line.loop_stalled(); });
    supervisor.join();
    QVERIFY(comes([&] { return device.safe == 1; }));
    line.post(hung);
    QVERIFY(comes([&] { return line.written().dropped == 1; }));
    line.post(numbered(3, line));
    QVERIFY(comes([&] { return device.tick == 3u; }));
    QCOMPARE(line.written().safe, std::int64_t{1});
    QCOMPARE(device.commands.load(), 3);
    QCOMPARE(device.torn.load(), 0);
  }

  void a_device_that_was_gone_is_found_again() {
    DeviceThread device;
    DeviceLine line(std::make_unique<ThreadSource>(device), time_, settings());
    line.open();
    line.start();
    for (std::int64_t n = 1; n <= 3; ++n) {
      device.unplug();
      QVERIFY(comes([&] { return line.snapshot().connections == n + 1; }));
      QVERIFY(comes([&] { return line.snapshot().any; }));
      QVERIFY(comes([&] {
        line.post(numbered(line.written().number + 1, line));
        return device.commands > 0;
      }));
      device.commands = 0;
    }
  }

  void its_state_reports_are_beats() {
    DeviceThread device;
    DeviceLine line(std::make_unique<ThreadSource>(device), time_, settings());
    line.open();
    line.start();
    QCOMPARE(line.period_ns(), std::int64_t{1'000'000});
    Pacer::Beat beat;
    QVERIFY(line.wait_for_beat(line.now(), beat));
    for (int i = 0; i < 50; ++i) {
      const Pacer::Beat before = beat;
      QVERIFY(line.wait_for_beat(line.now() + 60'000'000'000, beat));
      QVERIFY(beat.own_ns > before.own_ns);
      QCOMPARE(beat.own_ns % 250'000, before.own_ns % 250'000);
      QVERIFY(beat.date_ns >= before.date_ns);
    }
  }

  void the_last_command_is_written_before_it_ends() {
    DeviceThread device;
    DeviceLine line(std::make_unique<ThreadSource>(device), time_, settings());
    line.open();
    line.start();
    line.post(numbered(7, line));
    line.stop();
    QCOMPARE(line.written().number, std::int64_t{7});
    QVERIFY(comes([&] { return device.tick == 7u; }));
  }

 private:
  MonotonicTime time_;
};

QTEST_APPLESS_MAIN(TestDeviceLine)
#include "tst_device_line.moc"
