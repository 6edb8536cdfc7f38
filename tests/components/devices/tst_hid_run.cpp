// SPDX-License-Identifier: Apache-2.0
// A run in real time, with all its threads, against an emulated device behind a socket. What the
// machine does to the timing is not judged.
#include "components/register.hpp"
#include "framework/run.hpp"

// Before Qt, whose macros take words that the framework uses.
#include <QTemporaryDir>
#include <QTest>
#include <stdexcept>

#include "cli/emulator.hpp"
#include "framework/realtime/service_thread.hpp"

using namespace trocar;

namespace {

/// An emulated device that keeps up with the machine's time.
class EmulatedDevice {
 public:
  explicit EmulatedDevice(const std::string& path) : port_(cli::socket_port(path)) {}
  /// After it was unplugged for good.
  const hid::EmulatedLaparoscope& end() {
    thread_.reset();
    return emulator_.device();
  }

 private:
  void run(const StopFlag& stop) {
    PeriodicClock clock;
    clock.start(250'000);
    for (std::int64_t done = 0; !stop.raised();)
      for (const std::int64_t due = clock.wait().index; done <= due; ++done) emulator_.cycle();
  }
  std::unique_ptr<cli::DevicePort> port_;
  cli::Emulator emulator_{{}, *port_};
  std::optional<ServiceThread> thread_{std::in_place, "device",
                                       [this](const StopFlag& stop) { run(stop); }};
};

RunResult run_on(const std::string& path, ClockKind clock, double rate) {
  Registry registry;
  register_components(registry);
  Graph graph(registry);
  const Where where{"test", 1};
  const NodeId group = *graph.add("Laparoscope", "", where);
  graph.set({group, "device"}, {std::string("hid")}, where);
  graph.set({group, "path"}, {path}, where);
  graph.build_group(group);
  RunOptions options{.clock = clock, .duration = 0.8};
  options.wiring.rate = rate;
  options.timing.overload.policy = OverloadPolicy::ignore;
  for (const double at : {0.0, 0.2})
    options.requests.push_back({.at = at, .kind = Command::Kind::home});
  return run(graph, options);
}

QString refusal(const std::string& path, ClockKind clock, double rate) {
  try {
    run_on(path, clock, rate);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

class TestHidRun : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_run_goes_from_pages_to_off_data() {
    QTest::addColumn<int>("clock");
    QTest::newRow("by the machine's clock") << static_cast<int>(ClockKind::realtime);
    QTest::newRow("by the device's reports") << static_cast<int>(ClockKind::device);
  }
  void a_run_goes_from_pages_to_off() {
    QFETCH(int, clock);
    const QTemporaryDir folder;
    const std::string path = folder.filePath("device.sock").toStdString();
    EmulatedDevice device(path);
    const RunResult result = run_on(path, static_cast<ClockKind>(clock), 1000.0);
    const LoopStatistics& loop = result.main().loop;
    QVERIFY(loop.ticks + loop.skipped >= 800);
    QVERIFY(loop.ticks > 100);
    const hid::EmulatedLaparoscope& emulated = device.end();
    QVERIFY(emulated.intake().taken() > 50);
    QVERIFY(emulated.effort().isZero());
    if (!result.faults.empty()) qInfo("%s", result.faults[0].text().c_str());
    if (result.faults.empty()) QCOMPARE(emulated.machine().state(), hid::DeviceState::ready);
  }

  void what_cannot_run_says_why() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("device.sock").toStdString();
    QVERIFY(refusal(path, ClockKind::realtime, 1000.0)
                .startsWith("laparoscope.device: nobody listens at"));
    QVERIFY(refusal(path, ClockKind::simulated, 1000.0)
                .startsWith("laparoscope.device is a real device, and virtual time"));
    QVERIFY(refusal(path, ClockKind::realtime, 200.0).contains("needs at least 250 Hz"));
    EmulatedDevice device(path);
    QVERIFY(refusal(path, ClockKind::device, 4000.0)
                .startsWith("a rate of 4000 Hz cannot be paced by a device that reports at 1000"));
  }

  void without_a_device_nothing_paces() {
    Registry registry;
    register_components(registry);
    Graph graph(registry);
    graph.build_group(*graph.add("Laparoscope", "", {"test", 1}));
    try {
      run(graph, {.clock = ClockKind::device, .duration = 0.01});
      QFAIL("it ran");
    } catch (const std::invalid_argument& error) {
      QVERIFY(QString(error.what()).contains("no device of the graph paces"));
    }
  }
};

QTEST_GUILESS_MAIN(TestHidRun)
#include "tst_hid_run.moc"
