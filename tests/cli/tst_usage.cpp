// SPDX-License-Identifier: Apache-2.0
// What `trocar` says when it is asked for help, or called in a wrong way.
#include <QFile>
#include <QTest>

#include "tests/cli/trocar_process.hpp"

using namespace trocar::test;

class TestUsage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_answers_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("out");  // a part of it; "" for nothing at all
    QTest::addColumn<QByteArray>("err");
    const auto row = [](const char* name, const QStringList& arguments, int status, const char* out,
                        const char* err) {
      QTest::newRow(name) << arguments << status << QByteArray(out) << QByteArray(err);
    };
    row("version", {"--version"}, 0, "trocar 0.", "");
    row("help names the commands", {"--help"}, 0, "kinematics", "");
    row("help of a command has an example", {"list", "--help"}, 0, "Example:\n  trocar list", "");
    row("of graph", {"graph", "--help"}, 0, "Example:\n  trocar graph scripts/", "");
    row("of completion", {"completion", "--help"}, 0, "source <(trocar completion bash)", "");
    row("names alone", {"list", "--names"}, 0, "\nWall\n", "");
    row("of describe", {"describe", "--help"}, 0, "Example:\n  trocar describe Wall", "");
    row("of devices", {"devices", "--help"}, 0, "Example:\n  trocar devices", "");
    row("of doctor", {"doctor", "--help"}, 0, "Example:\n  trocar doctor", "");
    row("of stubs", {"stubs", "--help"}, 0, "Example:\n  trocar stubs wall.lua", "");
    row("of info", {"info", "--help"}, 0, "Example:\n  trocar info demo.mcap", "");
    row("of bench", {"bench", "--help"}, 0, "Example:\n  trocar bench --rates", "");
    row("of kinematics", {"kinematics", "--help"}, 0, "Example:\n  trocar kinematics fk", "");
    row("of a question", {"kinematics", "ik", "--help"}, 0, "| trocar kinematics ik", "");
    row("of dynamics", {"kinematics", "dynamics", "--help"}, 0, "I_ring_eff", "");
    row("of workspace", {"workspace", "--help"}, 0, "Example:\n  trocar workspace --tool-length",
        "");
    row("no command", {}, 2, "",
        "trocar: a command is needed: run, check, test, graph, list, describe");
    row("an unknown command", {"lsit"}, 2, "",
        "trocar: there is no command \"lsit\", did you mean \"list\"?");
    row("an unknown option", {"list", "--jsn"}, 2, "",
        "trocar: list: there is no option \"--jsn\", did you mean \"--json\"?");
    row("an unknown option with a value", {"info", "a.mcap", "--signal=x"}, 2, "",
        "there is no option \"--signal\", did you mean \"--signals\"?");
    row("no question", {"kinematics"}, 2, "", "kinematics: a command is needed: fk, ik, jacobian");
    row("an unknown question", {"kinematics", "jacobi"}, 2, "",
        "kinematics: there is no command \"jacobi\", did you mean \"jacobian\"?");
    row("an argument too many", {"devices", "Wall"}, 2, "",
        "trocar: devices: \"Wall\" is one argument too many");
    row("what cannot be listed", {"list", "Wall"}, 2, "", "Wall not in {components,plugins}");
    row("components can be listed by that word", {"list", "components"}, 0, "\n  Wall ", "");
    row("a missing argument", {"describe"}, 2, "", "trocar: describe: NAME is required");
    row("a component that does not exist", {"describe", "Wal7"}, 2, "",
        "trocar: describe: there is no component \"Wal7\"");
    row("a log that does not exist", {"info", "none.mcap"}, 2, "",
        "trocar: info: there is no file \"none.mcap\"");
    row("nobody to wait for",
        {"run", TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua", "--wait"}, 2, "",
        "--wait: needs --serve");
    row("no address",
        {"run", TROCAR_SOURCE_DIR "/scripts/tutorial/01_feel_a_wall.lua", "--serve",
         "300.1.1.1:80"},
        2, "", "\"300.1.1.1:80\" is no address to listen at");
    row("a folder for a log", {"info", TROCAR_SOURCE_DIR}, 1, "", "it is not a regular file");
    row("a script for a log", {"info", TROCAR_SOURCE_DIR "/README.md"}, 1, "", "trocar: info: ");
  }
  void it_answers() {
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    QFETCH(QByteArray, out);
    QFETCH(QByteArray, err);
    const Ran ran = run_trocar(arguments);
    QCOMPARE(ran.status, status);
    QVERIFY2(ran.out.contains(out) && ran.out.isEmpty() == out.isEmpty(), ran.out);
    QVERIFY2(ran.err.contains(err) && ran.err.isEmpty() == err.isEmpty(), ran.err);
  }

  void a_mistake_points_to_the_help() {
    QVERIFY(run_trocar({"info"}).err.endsWith("trocar: see trocar info --help\n"));
  }

  void a_reader_that_had_enough_is_no_error() {
    QProcess shell;
    shell.start("bash", {"-c",
                         "set -o pipefail; { echo q1,q2,q3,phi1,phi2,phi3; for i in {1..20000};"
                         " do echo 0,0,0,0,0,0; done; } | " TROCAR_BINARY
                         " kinematics jacobian | head -n 1; echo ${PIPESTATUS[1]}"});
    QVERIFY(shell.waitForFinished(60'000));
    QCOMPARE(shell.readAllStandardError(), QByteArray());
    QVERIFY(shell.readAllStandardOutput().endsWith("\n0\n"));
  }

  void a_full_disk_is_an_error() {
    if (!QFile::exists("/dev/full")) QSKIP("this system has no /dev/full");
    QProcess shell;
    shell.start("bash", {"-c", TROCAR_BINARY " --help > /dev/full"});
    QVERIFY(shell.waitForFinished(60'000));
    QCOMPARE(shell.exitCode(), 1);
    QVERIFY(shell.readAllStandardError().contains("cannot write the output"));
  }
};

QTEST_GUILESS_MAIN(TestUsage)
#include "tst_usage.moc"
