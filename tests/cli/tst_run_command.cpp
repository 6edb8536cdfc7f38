// SPDX-License-Identifier: Apache-2.0
// `trocar run` and `trocar check` as users call them: exit statuses, files, Ctrl-C.
#include <signal.h>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "tests/cli/trocar_process.hpp"

using namespace trocar::test;
using nlohmann::json;

namespace {

const QString demo = TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua";
const QString broken = TROCAR_SOURCE_DIR "/tests/data/ten_mistakes.lua";

QByteArray content(const QString& path) {
  QFile file(path);
  return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestRunCommand : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;

  QString script(const QByteArray& text) {
    QFile file(folder_.filePath("script.lua"));
    return file.open(QFile::WriteOnly) && file.write(text) == text.size() ? file.fileName() : "";
  }

  Ran simulate(const QString& path, const QStringList& more = {}) {
    return run_trocar(QStringList{"run", path, "--clock", "simulated"} + more);
  }

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(folder_.path())); }  // black boxes fall there
  void cleanupTestCase() { QDir::setCurrent(QDir::rootPath()); }

  void a_run_ends_with_a_status_data() {
    QTest::addColumn<QByteArray>("text");  // of a script; "" is the demo
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("said");
    const auto row = [](const char* name, const char* text, const QStringList& arguments,
                        int status, const char* said) {
      QTest::newRow(name) << QByteArray(text) << arguments << status << QByteArray(said);
    };
    row("a sound run", "", {"--for", "100ms"}, 0, "ran 100 ticks at 1000 Hz");
    row("a duration with a space", "", {"--for", "0.2 s"}, 0, "ran 200 ticks");
    row("a duration in minutes", "trocar.Constant { value = 1 }", {"--for=0.01min"}, 0,
        "ran 600 t");
    row("a duration of nothing", "", {"--for", "0s"}, 2, "--for: \"0s\" is no duration, e.g. 5s");
    row("a duration without a unit", "", {"--for", "5"}, 2, "\"5\" is no duration");
    row("a negative duration", "", {"--for=-1s"}, 2, "\"-1s\" is no duration");
    row("a duration that is none", "", {"--for", "long"}, 2, "\"long\" is no duration");
    row("an unknown clock", "", {"--clock", "wall"}, 2, "--clock");
    row("a guard spin as long as the period", "", {"--clock", "realtime", "--spin", "1ms"}, 2,
        "--spin: a guard spin of 1000 µs at a period of 1000 µs: 0 (off) or more, and shorter");
    row("a negative guard spin", "", {"--spin=-1us"}, 2, "--spin: \"-1us\" is negative: 0 (off)");
    row("a guard spin that is no time", "", {"--spin", "3mm"}, 2, "\"3mm\" is no time, e.g. 100us");
    row("in virtual time there is nothing to spin for", "", {"--for", "10ms", "--spin", "1ms"}, 0,
        "ran 10 ticks");
    row("an unknown policy of overload", "", {"--overload", "panic"}, 2, "--overload");
    row("a grace that is no time", "", {"--overload-grace", "5"}, 2,
        "\"5\" is no time, e.g. 500ms");
    row("a negative length", "", {"--overload-longest=-1ms"}, 2,
        "--overload-longest: \"-1ms\": overload.longest = -0.001: 0 s to 3600 s");
    row("half an overrun", "", {"--overload-allowed", "1.5"}, 2,
        "\"1.5\" is no whole number from 0 to 10000");
    row("too many overruns", "", {"--overload-allowed", "20000"}, 2,
        "--overload-allowed: \"20000\": overload.allowed = 20000: 0 to 10000");
    row("a seed", "", {"--for", "10ms", "--seed", "7"}, 0, "ran 10 ticks");
    row("a negative seed", "", {"--seed=-1"}, 2, "\"-1\" is no whole number");
    row("a seed that is too large", "", {"--seed", "99999999999999999999"}, 2,
        "is no whole number");
    row("a setting", "", {"--for", "10ms", "--set", "wall.stiffness=1 N/mm"}, 0, "ran 10 ticks");
    row("a setting of the wrong unit", "", {"--set", "wall.stiffness=1 N"}, 2,
        "--set: wall.stiffness = \"1 N\": needs N/m");
    row("a setting of nothing", "", {"--set", "wall.stifness=1 N/mm"}, 2,
        "did you mean \"wall.stiffness\"?");
    row("a setting without a value", "", {"--set", "wall"}, 2, "\"wall\" is no setting");
    row("a broken script", "trocar.Wal {}", {}, 2, "script.lua:1: there is no trocar.Wal");
    row("a script that fails", "error(\"why\")", {}, 2, "script.lua:1: why");
    row("a log that cannot be written", "", {"--record", "/nowhere/a.mcap"}, 1,
        "cannot create '/nowhere/a.mcap': No such file or directory");
    row("a folder for a log", "", {"--record", "/"}, 1, "cannot create '/'");
    row("a log without a name", "", {"--record", ""}, 2, "--record: needs a file name");
    row("a report without a name", "", {"--json", ""}, 2, "--json: needs a file name");
    row("a report that cannot be written, before the run", "", {"--json", "/nowhere/a"}, 2,
        "--json: \"/nowhere/a\" cannot be written");
    row("a fault",
        "local l = trocar.Laparoscope { hand = \"none\" }\n"
        "trocar.Spring { at = l.tip, stiffness = \"1 N/mm\", about = \"center\",\n"
        "  center = { 0, 0, \"1 m\" } }",
        {"--for", "1s"}, 1, "FAULT, first cause");
  }
  void a_run_ends_with_a_status() {
    QFETCH(QByteArray, text);
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    QFETCH(QByteArray, said);
    QStringList all = {"run", text.isEmpty() ? demo : script(text)};
    if (!arguments.contains("--clock")) all += {"--clock", "simulated"};
    const Ran ran = run_trocar(all + arguments);
    QVERIFY2((ran.out + ran.err).contains(said), ran.out + ran.err);
    QCOMPARE(ran.status, status);
    QVERIFY2(!ran.err.contains('\r'), "progress is for terminals only");
  }

  void a_script_that_is_missing_is_wrong_usage() {
    for (const char* command : {"run", "check"}) {
      const Ran ran = run_trocar({command, "none.lua"});
      QCOMPARE(ran.status, 2);
      QVERIFY((ran.out + ran.err).contains("none.lua: there is no script that can be read"));
    }
  }

  void the_report_is_json() {
    const QString path = folder_.filePath("report.json");
    const QString text = script(
        "print(\"hello\")\n"
        "local c = trocar.Constant { value = \"2 mm\" }\n"
        "for i = 1, 2 do local run = trocar.run { duration = \"0.1 s\" }\n"
        "trocar.publish(\"row\", { number = i, value = run:mean(c.value) }) end");
    const Ran to_file = simulate(text, {"--json", path});
    QVERIFY(to_file.out.startsWith("hello\n") && to_file.out.contains("\nrow\n"));
    const Ran to_output = simulate(text, {"--json", "-"});
    QCOMPARE(to_output.err, QByteArray("hello\n"));
    for (const QByteArray& written : {content(path), to_output.out}) {
      const json report = json::parse(written.toStdString());
      QCOMPARE(report["runs"].size(), std::size_t(2));
      QCOMPARE(report["runs"][0]["ticks"].get<int>(), 100);
      QCOMPARE(report["published"]["row"].size(), std::size_t(2));
      QCOMPARE(report["published"]["row"][1]["number"].get<int>(), 2);
      QVERIFY(qAbs(report["published"]["row"][1]["value"].get<double>() - 2e-3) < 1e-12);
    }
  }

  void the_same_run_leaves_the_same_bytes() {
    const auto record = [&](const char* name, const QStringList& more) {
      const QString path = folder_.filePath(name);
      const Ran ran = simulate(demo, QStringList{"--for", "5s", "--record", path} + more);
      return ran.status == 0 ? content(path) : QByteArray();
    };
    const QByteArray first = record("first.mcap", {});
    QVERIFY(first.size() > 1'000'000);
    QVERIFY(first == record("second.mcap", {}));
    QVERIFY(first != record("third.mcap", {"--seed", "2"}));
  }

  void record_redirects_a_logger() {
    const QString own = folder_.filePath("own.mcap");
    const QString other = folder_.filePath("other.mcap");
    const QString text =
        script("trocar.Constant { value = 1 }\ntrocar.Logger { file = \"" + own.toUtf8() + "\" }");
    QCOMPARE(simulate(text, {"--for", "0.1s"}).status, 0);
    QVERIFY(QFile::remove(own));
    QCOMPARE(simulate(text, {"--for", "0.1s", "--record", other}).status, 0);
    QVERIFY(QFile::exists(other) && !QFile::exists(own));
    QCOMPARE(run_trocar({"info", other}).status, 0);
  }

  void a_trip_leaves_a_black_box_unless_it_is_switched_off() {
    const auto files = [&] { return QDir(folder_.path()).entryList({"trip*.mcap"}); };
    const auto trip = [&](const QStringList& more) {
      const Ran ran = simulate(TROCAR_SOURCE_DIR "/tests/data/trip.lua", more);
      QCOMPARE(ran.status, 1);
      QVERIFY2(ran.out.contains("FAULT, first cause: handle wrench"), ran.out + ran.err);
    };
    trip({"--black-box", "off"});
    QCOMPARE(files(), QStringList{"trip_touch.mcap"});
    trip({});
    trip({});
    trip({"--black-box", "trip.mcap"});
    QCOMPARE(files(), (QStringList{"trip.blackbox-1.mcap", "trip.blackbox-2.mcap", "trip.mcap",
                                   "trip_touch.mcap"}));
    QVERIFY(content(folder_.filePath("trip.blackbox-1.mcap")) ==
            content(folder_.filePath("trip.blackbox-2.mcap")));
    const Ran info = run_trocar({"info", folder_.filePath("trip.mcap")});
    QVERIFY2(info.status == 0 && info.out.contains("Complete    yes"), info.out + info.err);
  }

  void a_broken_script_begins_no_log() {
    const QString path = folder_.filePath("none.mcap");
    QCOMPARE(simulate(broken, {"--record", path}).status, 2);
    QVERIFY(!QFile::exists(path));
  }

  void ctrl_c_ends_a_run_in_order() {
    const QString path = folder_.filePath("interrupted.mcap");
    QProcess process;
    process.start(TROCAR_BINARY, {"run", demo, "--record", path});
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(path).size() > 10'000, 10'000);  // it records
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(10'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    const QByteArray out = process.readAllStandardOutput();
    QVERIFY2(out.startsWith("stopped by the operator after "), out);
    QVERIFY2(out.contains(", 0 lost"), out);
    const Ran info = run_trocar({"info", path});
    QVERIFY2(info.status == 0 && info.out.contains("Complete    yes"), info.out + info.err);
  }

  void ctrl_c_ends_a_script_that_never_ends() {
    const QString path = folder_.filePath("endless.lua");
    QFile script(path);
    QVERIFY(script.open(QIODevice::WriteOnly));
    script.write("io.stderr:write('begun')\nwhile true do end\n");
    script.close();
    QProcess process;
    process.setReadChannel(QProcess::StandardError);
    process.start(TROCAR_BINARY, {"run", path});
    QVERIFY(process.waitForReadyRead(10'000));
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(10'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    const QByteArray err = process.readAllStandardError();
    QVERIFY2(err.contains("endless.lua:2: stopped by the operator"), err);
  }

  void a_realtime_run_reports_lateness() {
    const QString path = folder_.filePath("realtime.json");
    const Ran ran = run_trocar({"run", demo, "--for", "0.5s", "--json", path});
    QVERIFY2(ran.out.contains("  lateness "), ran.out);
    const json run = json::parse(content(path).toStdString())["runs"][0];
    QCOMPARE(run["ticks"].get<int>() + run["skipped"].get<int>(), 500);
    QCOMPARE(run["lateness"]["count"].get<int>(), run["ticks"].get<int>());
    QVERIFY(run["lateness"]["max"].get<double>() > 0.0);
  }

  /// A terminal of its own, by util-linux's `script`.
  void the_keys_of_a_terminal_are_the_operators_data() {
    QTest::addColumn<QByteArray>("keys");
    QTest::addColumn<int>("status");
    QTest::addColumn<bool>("stopped");
    QTest::newRow("q ends the run") << QByteArray("q") << 0 << false;
    QTest::newRow("space stops the rendering") << QByteArray(" q") << 1 << true;
    QTest::newRow("others do nothing") << QByteArray("xq") << 0 << false;
  }
  void the_keys_of_a_terminal_are_the_operators() {
    QFETCH(QByteArray, keys);
    QFETCH(int, status);
    QFETCH(bool, stopped);
    if (!terminals_are_possible()) QSKIP("there are no pseudo-terminals here");
    QProcess terminal;
    terminal.setProcessChannelMode(QProcess::MergedChannels);
    terminal.start(
        "script",
        {"-qec",
         QStringLiteral("%1 run %2 --overload ignore --black-box off").arg(TROCAR_BINARY, demo),
         "/dev/null"});
    QByteArray said;
    while (!said.contains("space stops the rendering") && terminal.waitForReadyRead(60'000))
      said += terminal.readAll();
    terminal.write(keys);
    QVERIFY2(terminal.waitForFinished(60'000), said);
    said += terminal.readAll();
    QVERIFY2(terminal.exitCode() == status, said);
    QVERIFY2(said.contains("operator stop in laparoscope.device") == stopped, said);
  }

  void a_realtime_run_tells_what_its_punctuality_costs() {
    const QString path = folder_.filePath("spin.json");
    const Ran ran = run_trocar(
        {"run", demo, "--for", "0.3s", "--spin", "50us", "--hold-latency", "--json", path});
    QVERIFY2(ran.out.contains("  guard spin 50 µs: "), ran.out);
    QVERIFY2(ran.out.contains("/dev/cpu_dma_latency"), ran.out);  // held, or why not
    const json run = json::parse(content(path).toStdString())["runs"][0];
    QCOMPARE(run["spin"].get<double>(), 5e-5);
    QVERIFY(run["spun"].get<double>() > 0.0);
    QVERIFY(run["latency_held"].is_boolean() && run["overruns"].is_number());
  }

  // Thirty plants at 10 kHz: no processor keeps up with that.
  void an_overload_ends_the_run_with_its_report() {
    const QString text = script(
        "for i = 1, 30 do trocar.Laparoscope { name = 'l' .. i, hand = 'none' } end\n"
        "trocar.run { rate = '10 kHz', duration = '5 s' }");
    const Ran ran = run_trocar({"run", text, "--overload", "end"});
    QCOMPARE(ran.status, 1);
    // A machine that is busy besides may find the heartbeat missing first.
    QVERIFY2(ran.out.contains(": overload in main at tick ") ||
                 ran.out.contains(": loop stalled in main at tick "),
             ran.out);
  }

  void check_finds_every_mistake() {
    const Ran good = run_trocar({"check", demo});
    QCOMPARE(good.status, 0);
    QVERIFY(good.out.endsWith("components, no mistakes\n"));
    const Ran bad = run_trocar({"check", broken});
    QCOMPARE(bad.status, 2);
    QVERIFY2(bad.out.endsWith("\n10 mistakes\n"), bad.out);
    const json report = json::parse(run_trocar({"check", broken, "--json"}).out.toStdString());
    QCOMPARE(report["findings"].size(), std::size_t(10));
    QCOMPARE(report["findings"][0]["line"].get<int>(), 5);
    const json none = json::parse(run_trocar({"check", demo, "--json"}).out.toStdString());
    QVERIFY(none["findings"].is_array() && none["findings"].empty());
  }

  void of_many_runs_only_those_with_something_to_tell_are_listed() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("many.lua");
    QFile file(path);
    QVERIFY(file.open(QFile::WriteOnly) &&
            file.write("local laparoscope = trocar.Laparoscope {}\n"
                       "for i = 1, 25 do\n"
                       "  trocar.run { duration = '0.1 s',\n"
                       "    requests = i == 7 and { { at = '0.05 s', ask = 'stop' } } or nil }\n"
                       "end\n") > 0);
    file.close();
    const Ran ran = run_trocar({"run", path, "--clock", "simulated", "--black-box", "off"});
    QVERIFY2(ran.out.startsWith("25 runs: 2.5 s of virtual time in "), ran.out);
    QVERIFY2(ran.out.contains(" s, 1 with faults\nrun 7: 0.100 s at 1000 Hz"), ran.out);
    QCOMPARE(ran.out.count("\nrun "), 1);
  }
};

QTEST_GUILESS_MAIN(TestRunCommand)
#include "tst_run_command.moc"
