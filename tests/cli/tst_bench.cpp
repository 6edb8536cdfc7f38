// SPDX-License-Identifier: Apache-2.0
// `trocar bench` as users call it: the shape of what it says, no figure.
#include <signal.h>

#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "tests/cli/trocar_process.hpp"

using namespace trocar::test;
using nlohmann::json;

namespace {

QByteArray content(const QString& path) {
  QFile file(path);
  return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_measures_both_loops_at_each_rate() {
    const QTemporaryDir folder;
    const QString csv = folder.filePath("bench.csv"), report = folder.filePath("bench.json");
    const Ran ran = run_trocar({"bench", "--rates", "1kHz,4kHz", "--rounds", "2", "--round-time",
                                "200ms", "--spin", "50us", "--csv", csv, "--json", report});
    QVERIFY2(ran.status == 0 && ran.err.isEmpty(), ran.err);
    for (const char* part :
         {"1 kHz, a period of 1000 µs, 2 rounds", "4 kHz, a period of 250 µs, 2 rounds",
          "lateness [µs]", "guard spin", "The machine", "kernel", "timer slack"})
      QVERIFY2(ran.out.contains(part), ran.out);
    QVERIFY2(!ran.out.contains("DRIFTS"), ran.out);

    const json all = json::parse(content(report).toStdString());
    QCOMPARE(all["rates"].size(), std::size_t{2});
    qint64 samples = 0;
    for (const json& rate : all["rates"])
      for (const char* loop : {"bare", "trocar"}) {
        const json& one = rate[loop];
        const int used = one["slots"].get<int>();
        // A stall at the very end skips slots beyond it.
        QVERIFY(used + one["skipped"].get<int>() >= 0.4 * rate["rate"].get<double>() - 0.5);
        QVERIFY(one["adds_up"].get<bool>());
        QVERIFY(one["p50"]["median"].get<double>() <= one["max"]["median"].get<double>());
        samples += used;
      }
    qint64 counted = 0;
    for (const QByteArray& line : content(csv).split('\n').mid(1))
      if (!line.isEmpty()) counted += line.split(',').at(4).toLongLong();
    QCOMPARE(counted, samples);
  }

  void a_wrong_option_says_what_is_possible_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char* name, const QStringList& arguments, const char* says) {
      QTest::newRow(name) << arguments << QByteArray(says);
    };
    row("no rounds", {"--rounds", "0"}, "--rounds: \"0\" is no number of rounds: 1 to 1000");
    row("rounds that are no number", {"--rounds", "many"}, "1 to 1000 are possible");
    row("a rate without a unit", {"--rates", "1000"}, "\"1000\" is no rate, e.g. 1kHz or 250Hz");
    row("a rate that is too high", {"--rates", "1kHz,1MHz"}, "\"1MHz\" is no rate");
    row("rounds of no time", {"--round-time", "0s"}, "--round-time: \"0s\" is no duration");
    row("rounds of an hour", {"--round-time", "1h"}, "--round-time");
    row("rounds of a thousand seconds", {"--round-time", "1000s"}, "longer than the 600 s");
    row("a round with too few slots", {"--rates", "10Hz"},
        "\"1s\" has 10 slots at 10 Hz: at least 100 are needed");
    row("a spin as long as a period", {"--spin", "100us"},
        "--spin: a guard spin of 100 µs at a period of 100 µs");
    row("a negative spin", {"--spin=-1us"}, "is negative");
    row("two reports for one place", {"--csv", "-", "--json", "-"},
        "only one of --csv and --json can go to standard output");
    row("an option that does not exist", {"--round"}, "did you mean \"--rounds\"?");
  }
  void a_wrong_option_says_what_is_possible() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, says);
    const Ran ran = run_trocar(QStringList{"bench"} + arguments);
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.contains(says), ran.err);
    QVERIFY(ran.out.isEmpty());
  }

  void a_file_that_cannot_be_written_is_told_before_anything_is_measured() {
    const Ran ran = run_trocar({"bench", "--csv", "/nowhere/bench.csv"});
    QCOMPARE(ran.status, 1);
    QVERIFY2(ran.err.contains("bench: cannot write \"/nowhere/bench.csv\""), ran.err);
  }

  void a_report_to_standard_output_stands_alone() {
    const Ran ran = run_trocar(
        {"bench", "--rates", "1kHz", "--rounds", "1", "--round-time", "100ms", "--json", "-"});
    QCOMPARE(ran.status, 0);
    QCOMPARE(json::parse(ran.out.toStdString())["rates"].size(), std::size_t{1});
  }

  void ctrl_c_ends_it_with_what_was_measured() {
    const QTemporaryDir folder;
    QProcess process;
    process.start(TROCAR_BINARY,
                  {"bench", "--rates", "1kHz", "--rounds", "1000", "--round-time", "100ms"});
    QVERIFY(process.waitForStarted());
    QVERIFY(!process.waitForFinished(1500));
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(10'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    const QByteArray out = process.readAllStandardOutput(), err = process.readAllStandardError();
    if (process.exitCode() == 1)  // a slow machine
      QVERIFY2(err.contains("before a round was complete"), err);
    else
      QVERIFY2(out.contains("Stopped by the operator"), out);
  }
};

QTEST_GUILESS_MAIN(TestBench)
#include "tst_bench.moc"
