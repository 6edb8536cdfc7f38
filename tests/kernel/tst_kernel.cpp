// SPDX-License-Identifier: Apache-2.0
// `trocar run` and `trocar emulate` on a kernel of Debian's, in QEMU: the emulated device is a USB
// gadget, plugged into the same kernel by dummy_hcd, and the driver finds it by hidapi. What the
// machine's time does is judged loosely; names, order, counts and the device's own time are not.
//
// TROCAR_KERNEL_TRANSCRIPT judges what an earlier run left; boot.sh tells the other variables.
#include <fmt/format.h>

#include <QFile>
#include <QProcess>
#include <QTest>

#include "tests/kernel/transcript.hpp"

using namespace trocar::test;

namespace {

Transcript transcript;

constexpr double longest_ms = 10.0;         // until the effort is zero
constexpr double watchdog_ms = 8.0 + 0.25;  // of the firmware, and the cycle in which it looks
constexpr double heard_longest = 0.5;       // [s] from an order until the fault

struct Fault {
  double time = 0.0;
  std::string name;
};

std::vector<Fault> faults() {
  std::vector<Fault> all;
  const nlohmann::json report = transcript.json("faults.json");
  if (report.is_discarded() || report["runs"].size() != 1) return all;
  for (const auto& one : report["runs"][0]["faults"])
    all.push_back(
        {one["time"], one["cause"].get<std::string>() + ": " + one["detail"].get<std::string>()});
  return all;
}

/// The first fault after something was done, and before the next was.
Fault first_fault_of(const std::string& what) {
  if (!transcript.asked.contains(what)) return {.name = "it was not tried"};
  const double begin = transcript.asked.at(what);
  double end = 1e9;
  for (const auto& [other, time] : transcript.asked)
    if (time > begin) end = std::min(end, time);
  for (const Fault& fault : faults())
    if (fault.time >= begin && fault.time < end) return fault;
  return {};
}

nlohmann::json finding(const char* file, const std::string& key) {
  const nlohmann::json all = transcript.json(file);
  if (all.is_object())
    for (const auto& one : all["findings"])
      if (one["key"] == key) return one;
  return {{"level", "not there"}, {"finding", ""}, {"cure", ""}};
}

std::string level(const char* file, const std::string& key) {
  return finding(file, key)["level"].get<std::string>();
}

/// @return exit status of boot.sh
int boot(const QString& file) {
  QProcess process;
  process.setProcessChannelMode(QProcess::ForwardedChannels);
  process.start("bash", {TROCAR_SOURCE_DIR "/tests/kernel/boot.sh", TROCAR_BUILD_DIR, file});
  return process.waitForFinished(-1) && process.exitStatus() == QProcess::NormalExit
             ? process.exitCode()
             : 1;
}

}  // namespace

class TestKernel : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everything_was_tried() {
    for (const std::string& failure : transcript.failures) qWarning("%s", failure.c_str());
    QVERIFY2(transcript.complete, "the emulated machine did not get to its end");
    QVERIFY(transcript.failures.empty());
    qInfo("kernel %s", transcript.kernel.c_str());
  }

  void the_device_is_found() {
    const nlohmann::json devices = transcript.json("devices.json");
    QVERIFY2(devices.is_array() && devices.size() == 1, "not one device");
    QVERIFY2(devices.dump().find("1209:0001") != std::string::npos ||
                 (devices[0]["vendor"] == "1209" && devices[0]["product"] == "0001"),
             devices.dump().c_str());
    QCOMPARE(level("doctor.json", "device"), std::string("good"));
  }

  void who_may_not_open_it_is_told_the_cure() {
    QCOMPARE(level("doctor_nobody.json", "device"), std::string("problem"));
    const std::string cure = finding("doctor_nobody.json", "device")["cure"];
    QVERIFY2(cure.find("udevadm") != std::string::npos, cure.c_str());
    QCOMPARE(level("doctor_cured.json", "device"), std::string("good"));
  }

  void limits_that_a_cure_raises_are_raised() {
    const std::string said = transcript.files["cures.txt"];
    QVERIFY2(said.find("PASS   : TestDoctor::their_cures_work()") != std::string::npos,
             said.c_str());
    QVERIFY2(said.find("0 skipped") != std::string::npos, said.c_str());
  }

  void it_renders_undisturbed() {
    const nlohmann::json report = transcript.json("undisturbed.json");
    QVERIFY2(report.is_object() && report["runs"].size() == 1,
             transcript.files["undisturbed.txt"].c_str());
    const nlohmann::json& run = report["runs"][0];
    QVERIFY2(run["faults"].empty(), run["faults"].dump().c_str());
    const nlohmann::json& reports = report["published"]["reports"][0];
    const double ticks = run["ticks"], skipped = run["skipped"];
    const double period = 1.0 / transcript.rate;
    qInfo(
        "%.0f Hz for %.0f s: %.0f ticks, %.0f missed; reports: %.0f lost, %.0f refused, %.0f "
        "repeated",
        transcript.rate, run["duration"].get<double>(), ticks, skipped,
        reports["lost"].get<double>(), reports["refused"].get<double>(),
        reports["repeated"].get<double>());
    QCOMPARE(run["rate"].get<double>(), transcript.rate);
    QVERIFY(skipped <= 1e-3 * ticks);
    QVERIFY(reports["lost"].get<double>() <= 1e-3 * ticks);
    QCOMPARE(reports["repeated"].get<double>(), 0.0);
    QCOMPARE(reports["scale"].get<double>(), 1.0);
    QVERIFY2(reports["wall"].get<double>() > 5.0, "the hand did not feel the wall");
    const std::map<std::string, double> at_most{
        {"report_age", period}, {"round_trip", 3.0 * period}, {"write_time", period}};
    QCOMPARE(report["published"]["way"].size(), at_most.size());
    for (const auto& row : report["published"]["way"]) {
      const std::string signal = row["signal"];
      qInfo("%-10s median %4.0f us, 99 %% %4.0f us, worst %4.0f us", signal.c_str(),
            1e6 * row["median"].get<double>(), 1e6 * row["most"].get<double>(),
            1e6 * row["worst"].get<double>());
      QVERIFY(row["median"].get<double>() > 0.0);
      QVERIFY(row["most"].get<double>() < at_most.at(signal));
    }
  }

  void a_fault_is_named_and_over_in_time_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("named");
    QTest::addColumn<QString>("device");
    const auto row = [](const char* what, const char* named, const char* device) {
      QTest::newRow(what) << QString(what) << QString(named) << QString(device);
    };
    // What the device latched besides depends on who was first, but for those of its own.
    row("silence", "position lost: no reports", "");
    row("corruption", "position lost: reports corrupted", "");
    row("delay", "position lost: no reports", "");
    row("stuck", "position lost: reports repeated", "");
    row("jump", "device fault: encoder jump in the device", "fault of encoder jump");
    row("deaf", "device fault: watchdog of the device", "fault of watchdog");
    row("unplug", "position lost: unplugged", "");
  }
  void a_fault_is_named_and_over_in_time() {
    QFETCH(QString, what);
    QFETCH(QString, named);
    QFETCH(QString, device);
    const std::string state = transcript.states[what.toStdString()];
    const Fault fault = first_fault_of(what.toStdString());
    QCOMPARE(QString::fromStdString(fault.name), named);
    QVERIFY(fault.time - transcript.asked[what.toStdString()] < heard_longest);
    QVERIFY2(QString::fromStdString(state).startsWith(device), state.c_str());
    const EffortZero zero = effort_zero(state);
    QVERIFY2(zero.said, state.c_str());
    qInfo("%s; zero %.2f ms after the last good report, %.2f ms after the last command",
          fault.name.c_str(), zero.after_report, zero.after_command);
    QVERIFY(zero.after_report <= longest_ms);
    QVERIFY(zero.after_command <= watchdog_ms);
  }

  void a_motor_that_is_too_hot_ends_rendering_and_not_the_hold() {
    QCOMPARE(first_fault_of("heat").name, std::string("device fault: temperature of a motor"));
    const std::string state = transcript.states["heat"];
    QVERIFY2(state.starts_with("fault of temperature") && !effort_zero(state).said, state.c_str());
  }

  void a_driver_that_is_gone_ends_in_the_devices_watchdog_data() {
    QTest::addColumn<QString>("what");
    QTest::newRow("stopped") << QString("stopped");
    QTest::newRow("killed") << QString("killed");
  }
  void a_driver_that_is_gone_ends_in_the_devices_watchdog() {
    QFETCH(QString, what);
    const std::string state = transcript.states[what.toStdString()];
    QVERIFY2(state.starts_with("fault of watchdog"), state.c_str());
    const EffortZero zero = effort_zero(state);
    QVERIFY2(zero.said, state.c_str());
    qInfo("zero %.2f ms after the last command", zero.after_command);
    QVERIFY(zero.after_command >= 8.0 && zero.after_command <= watchdog_ms);
  }

  void one_that_was_stopped_says_so_and_renders_again() {
    const std::string name = first_fault_of("stopped").name;
    qInfo("%s", name.c_str());
    QVERIFY2(name.starts_with("loop stalled: ") || name.starts_with("overload: ") ||
                 name == "device fault: watchdog of the device",
             name.c_str());
    QVERIFY(transcript.states["again"].starts_with("engaged"));
    QVERIFY(transcript.states["rendering"].starts_with("engaged"));
  }

  void nothing_else_went_wrong() {
    const std::vector<std::string> order{"silence", "corruption", "delay",  "stuck",  "jump",
                                         "heat",    "deaf",       "unplug", "stopped"};
    QCOMPARE(transcript.asked.size(), order.size());
    for (std::size_t i = 1; i < order.size(); ++i)
      QVERIFY(transcript.asked[order[i]] > transcript.asked[order[i - 1]]);
    for (const Fault& fault : faults())
      QVERIFY2(fault.time >= transcript.asked.at("silence"),
               ("before anything was done: " + fault.name).c_str());
  }
};

int main(int count, char** arguments) {
  const QByteArray flavour = qEnvironmentVariable("TROCAR_KERNEL_FLAVOUR", "amd64").toUtf8();
  QString file = qEnvironmentVariable("TROCAR_KERNEL_TRANSCRIPT");
  if (file.isEmpty()) {
    file = QString(TROCAR_BUILD_DIR "/kernel/transcript-%1.txt").arg(QString(flavour));
    if (const int status = boot(file); status != 0) return status;
  }
  QFile text(file);
  if (!text.open(QFile::ReadOnly)) {
    fmt::print(stderr, "there is no transcript {}\n", file.toStdString());
    return 1;
  }
  transcript = transcript_of(text.readAll().toStdString());
  TestKernel test;
  return QTest::qExec(&test, count, arguments);
}
#include "tst_kernel.moc"
