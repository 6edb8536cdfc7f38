// SPDX-License-Identifier: Apache-2.0
// What is typed while a graph runs, and what comes back.
#include "cli/console.hpp"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/trocar_process.hpp"
#include "tests/support/run_rig.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

/// A console whose rows are those of a run of 10 ticks.
struct ConsoleRig {
  ConsoleRig() { rig.run(0.01, {&rows}); }

  QString answer(const char* line) {
    return QString::fromStdString(console.answer(line, control)).simplified();
  }

  RunRig rig;
  RowSnapshot rows;
  WiringOptions options{};
  std::unique_ptr<WiredGraph> live = wire(rig.graph, options);
  std::deque<CommandQueue> queues = std::deque<CommandQueue>(1);
  Reloads reloads{*live};
  RunControl control{rig.graph, options, *live, queues, reloads};
  cli::Console console{rows};
};

QStringList wall(const QStringList& more) {
  return QStringList{"run", TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua", "--console",
                     "--black-box", "off"} +
         more;
}

}  // namespace

class TestConsole : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_answers_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QString>("answer");
    const auto row = [](const char* line, const char* answer) {
      QTest::newRow(*line == '\0' ? "nothing" : line) << QByteArray(line) << QString(answer);
    };
    row("", "");
    row("meter.value", "meter.value 11 N at 0.009 s");
    row("  meter.force.y ", "meter.force.y 18 N at 0.009 s");
    row("meter.force",
        "meter.force.x 9 N at 0.009 s meter.force.y 18 N at 0.009 s meter.force.z -9 N at 0.009 s");
    row("meter.odd", "meter.odd true at 0.009 s");
    row("meter.gain", "meter.gain = 2 N (at most 9 N)");
    row("meter.gain = 3 N", "meter.gain: 2 N (at most 9 N) -> 3 N (at most 9 N)");
    row("meter.gain = 30 N", "meter.gain = \"30 N\": must be at most 9 N");
    row("meter.gane = 3 N", "nothing is called \"meter.gane\", did you mean \"meter.gain\"?");
    row("stop", "asked: stop");
    row("sotp", "nothing is called \"sotp\", did you mean \"stop\"?");
    row("anything", "nothing is called \"anything\"; help says what there is");
    row("list gain", "meter.gain 2 N (at most 9 N), a parameter");
    row("list nothing", "no signal's or parameter's name contains \"nothing\"");
  }
  void it_answers() {
    QFETCH(QByteArray, line);
    QFETCH(QString, answer);
    ConsoleRig rig;
    QCOMPARE(rig.answer(line.constData()), answer);
  }

  void a_request_reaches_the_loop() {
    ConsoleRig rig;
    rig.answer("engage");
    const auto command = rig.queues[0].try_pop();
    QVERIFY(command && command->kind == Command::Kind::engage);
  }

  void it_completes_names() {
    ConsoleRig rig;
    const auto completed = [&](const char* begin) {
      QStringList names;
      for (const std::string& name : rig.console.completions(begin, rig.control))
        names << QString::fromStdString(name);
      return names;
    };
    QCOMPARE(completed("e"), (QStringList{"end", "engage"}));
    QCOMPARE(completed("meter.f"),
             (QStringList{"meter.force", "meter.force.x", "meter.force.y", "meter.force.z"}));
    QCOMPARE(completed("meter.g"), (QStringList{"meter.gain"}));
    QVERIFY(completed("x").isEmpty());
  }

  void a_run_obeys_lines_of_a_pipe() {
    const Ran ran =
        run_trocar(wall({"--for", "60s"}),
                   "wall.stiffness = 1 N/mm\nwall.stiffness = 1 mm\nwall.stiffness\nend");
    QCOMPARE(ran.status, 0);
    for (const char* text : {"wall.stiffness: 2.2 N/mm (0–50 N/mm) -> 1 N/mm (0–50 N/mm)\n",
                             "wall.stiffness = \"1 mm\": needs N/m",
                             "wall.stiffness = 1 N/mm (0–50 N/mm)\n", "asked: end\n"})
      QVERIFY2(ran.out.contains(text), ran.out);
  }

  void a_terminal_completes_and_remembers() {
    if (!terminals_are_possible()) QSKIP("no terminals here");
    const QTemporaryDir home;
    const auto type = [&](const QByteArray& keys) {
      QProcess process;
      QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
      environment.insert("XDG_STATE_HOME", home.path());
      environment.insert("TERM", "xterm");
      process.setProcessEnvironment(environment);
      process.start("script", {"-qec", "'" TROCAR_BINARY "' " + wall({"--for", "60s"}).join(' '),
                               "/dev/null"});
      process.write(keys);
      const bool ended = process.waitForFinished(60'000);
      return std::pair(ended, process.readAllStandardOutput());
    };
    const auto [ended, out] = type("wall.sti\t = 1 N/mm\nend\n");
    QVERIFY2(ended && out.contains("2.2 N/mm (0–50 N/mm) -> 1 N/mm"), out);
    QFile history(home.filePath("trocar/history"));
    QVERIFY(history.open(QFile::ReadOnly));
    const auto [again, later] = type("\x1b[A\x1b[A\nend\n");
    QVERIFY2(again && later.contains("2.2 N/mm (0–50 N/mm) -> 1 N/mm"), later);
  }

  void it_is_for_real_time() {
    const Ran ran = run_trocar(wall({"--clock", "simulated"}));
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.contains("--console: needs --clock realtime"), ran.err);
  }
};

QTEST_GUILESS_MAIN(TestConsole)
#include "tst_console.moc"
