// SPDX-License-Identifier: Apache-2.0
// `trocar workspace` as a user runs it.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/trocar_process.hpp"

using namespace trocar::test;

namespace {

/// Fewer points than by default.
const QStringList quick = {"--shifts", "4", "--tips", "1024", "--poses", "8192"};

QJsonObject json_of(const QStringList& arguments) {
  const Ran ran = run_trocar(QStringList{"workspace", "--json", "-"} + quick + arguments);
  return QJsonDocument::fromJson(ran.out).object();
}

double volume_of(const QStringList& arguments) {
  return json_of(arguments).value("volume").toDouble();
}

QByteArray read_file(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestWorkspaceCommand : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_tells_the_figures_of_the_default_device() {
    const Ran ran = run_trocar({"workspace"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.status, 0);
    for (const char* part :
         {"cm³, standard error", "roll (theta)                 -240.0 to 240.0 deg",
          "119.7   98.2   75.3   63.0   49.9", "yaw (alpha)                  -45.0 to 45.0 deg",
          "peak force, least [N]", "continuous force, least [N]", "condition number, median",
          "manipulability, median"})
      QVERIFY2(ran.out.contains(part), qPrintable(QString(part) + "\n" + ran.out));
    for (const QByteArray& line : ran.out.split('\n'))
      QVERIFY2(QString::fromUtf8(line).size() <= 80, line);
  }

  void json_holds_the_same_for_programs() {
    const QJsonObject json = json_of({});
    const double volume = json["volume"].toDouble();
    QVERIFY(std::abs(volume - 3.508e-3) < 0.06e-3);
    QVERIFY(json["volume_standard_error"].toDouble() < 0.01 * volume);
    QCOMPARE(json["tips_tried"].toInt(), 4096);
    QCOMPARE(json["settings"].toObject()["tool_length"].toDouble(), 0.150);
    QCOMPARE(json["settings"].toObject()["seed"].toInt(), 1);
    QVERIFY(!json["settings"].toObject().contains("threads"));
    QVERIFY(std::abs(json["extent"].toObject()["yaw"].toArray()[1].toDouble() - 0.7854) < 0.001);
    const QJsonObject first = json["translations"].toArray()[0].toObject();
    QVERIFY(std::abs(first["insertion"].toDouble() - 0.1197) < 1e-4);
    QVERIFY(std::abs(first["roll"].toDouble() - 4.18879) < 1e-5);
    int poses = 0;
    for (const QJsonValue& cell : json["cells"].toArray())
      poses += cell.toObject()["poses"].toInt();
    QCOMPARE(poses, json["poses"].toInt());
    QVERIFY(json["cells"].toArray()[40].toObject()["peak_force"].toObject().contains("median"));
  }

  void csv_is_the_map() {
    const Ran ran = run_trocar(QStringList{"workspace", "--csv", "-"} + quick);
    QCOMPARE(ran.status, 0);
    const QList<QByteArray> lines = ran.out.trimmed().split('\n');
    QCOMPARE(lines.at(0),
             QByteArray("x,y,z,filled,poses,condition_least,condition_median,condition_greatest,"
                        "manipulability_least,manipulability_median,manipulability_greatest,"
                        "peak_force_least,peak_force_median,peak_force_greatest,"
                        "continuous_force_least,continuous_force_median,"
                        "continuous_force_greatest"));
    QVERIFY(lines.size() > 300);
    for (const QByteArray& line : lines) QCOMPARE(line.count(','), 16);
  }

  void files_and_text_go_together() {
    const QTemporaryDir folder;
    const Ran ran = run_trocar(QStringList{"workspace", "--csv", folder.filePath("map.csv"),
                                           "--json", folder.filePath("all.json")} +
                               quick);
    QCOMPARE(ran.status, 0);
    QVERIFY(ran.out.startsWith("Workspace of the laparoscope"));
    QVERIFY(read_file(folder.filePath("map.csv")).startsWith("x,y,z,"));
    QVERIFY(QJsonDocument::fromJson(read_file(folder.filePath("all.json"))).isObject());
  }

  void the_number_of_threads_does_not_change_a_byte() {
    const auto answer = [](const char* threads, const char* format) {
      return run_trocar(QStringList{"workspace", format, "-", "--threads", threads} + quick).out;
    };
    for (const char* format : {"--json", "--csv"}) {
      const QByteArray alone = answer("1", format);
      QVERIFY(alone.size() > 1000);
      for (const char* threads : {"2", "3"}) QVERIFY(answer(threads, format) == alone);
    }
  }

  void a_seed_gives_its_own_answer() {
    QVERIFY(volume_of({"--seed", "2"}) != volume_of({}));
    QCOMPARE(volume_of({"--seed", "2"}), volume_of({"--seed", "2"}));
  }

  void geometry_and_limits_come_from_options_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<bool>("larger");  // than the default's volume
    QTest::newRow("a longer tool") << QStringList{"--tool-length", "170 mm"} << true;
    QTest::newRow("a narrower cone") << QStringList{"--tilt=30 deg"} << false;
    QTest::newRow("a shorter stroke") << QStringList{"--slider-lowest", "-0.28 m"} << false;
  }
  void geometry_and_limits_come_from_options() {
    QFETCH(QStringList, arguments);
    QFETCH(bool, larger);
    QCOMPARE(volume_of(arguments) > volume_of({}), larger);
  }

  void efforts_and_weight_change_the_force_alone() {
    const auto strongest = [](const QJsonObject& json) {
      return json["engagement"].toArray()[3].toObject()["continuous_force"].toObject()["median"];
    };
    const QJsonObject usual = json_of({}), weaker = json_of({"--ring-continuous", "1.35 N m"}),
                      held = json_of({"--weight", "--mount", "pitch = 20 deg"});
    QVERIFY(std::abs(strongest(weaker).toDouble() / strongest(usual).toDouble() - 0.5) < 0.02);
    QVERIFY(strongest(held).toDouble() < strongest(usual).toDouble());
    QCOMPARE(held["volume"], usual["volume"]);
    QVERIFY(held["settings"].toObject().contains("tool_mass"));
  }

  void bad_input_is_refused_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("err");
    const auto row = [](const char* name, const QStringList& arguments, int status,
                        const char* err) {
      QTest::newRow(name) << arguments << status << QByteArray(err);
    };
    row("a misspelt option", {"--tool-lenght", "1 m"}, 2,
        "there is no option \"--tool-lenght\", did you mean \"--tool-length\"?");
    row("as a script spells it", {"--tool_length", "1 m"}, 2, "did you mean \"--tool-length\"?");
    row("another unit", {"--tool-length", "5 kg"}, 2,
        "--tool-length: \"5 kg\": needs m, e.g. \"5 mm\" (1–2000 mm)");
    row("no unit", {"--tilt", "45"}, 2, "--tilt: \"45\": needs rad, e.g. \"45 deg\" (0–89 deg)");
    row("no such unit", {"--tilt", "45 dge"}, 2, "--tilt: \"45 dge\": ");
    row("out of its range", {"--link-length", "9 m"}, 2,
        "--link-length: \"9 m\": must be within 1–2000 mm");
    row("not a number", {"--ring-peak", "nan N m"}, 2, "--ring-peak: \"nan N m\": ");
    row("no choice", {"--roll", "gimbal"}, 2, "--roll: gimbal not in {gimbal_outer_y");
    row("links too short for the base", {"--link-length", "90 mm"}, 2,
        "--link-length = 0.09: must exceed base_radius - platform_radius");
    row("rails upside down", {"--slider-lowest", "-100 mm"}, 2,
        "--slider-lowest = -0.1: must be below slider_high = -0.19 m; swap the two");
    row("a sleeve longer than the tool", {"--engagement-highest", "151 mm"}, 2,
        "--engagement-highest = 0.151: must lie above");
    row("no power of 2", {"--tips", "1000"}, 2, "--tips = 1000: needs a power of 2");
    row("half a tip", {"--tips", "1024.5"}, 2, "--tips: \"1024.5\": needs a whole number");
    row("one shift", {"--shifts", "1"}, 2, "--shifts: \"1\": must be within 2–1024");
    row("more threads than can be", {"--threads", "-1"}, 2, "--threads: \"-1\": must be within");
    row("cells too small", {"--cell", "1 mm"}, 2, "--cell = 0.001: gives more than 200000 cells");
    row("two for standard output", {"--csv", "-", "--json", "-"}, 2,
        "only one of --csv and --json");
    row("no file name", {"--csv", ""}, 2, "needs a file name");
    row("a folder that is not there", {"--csv", "none/there.csv"}, 1,
        "cannot write \"none/there.csv\"");
    row("nothing in reach", {"--slider-lowest", "-1.001 m", "--slider-highest", "-1 m"}, 1,
        "no pose inside all limits was found");
  }
  void bad_input_is_refused() {
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    QFETCH(QByteArray, err);
    const Ran ran = run_trocar(QStringList{"workspace"} + arguments);
    QCOMPARE(ran.status, status);
    QVERIFY2(ran.err.contains(err), ran.err);
    QCOMPARE(ran.out, QByteArray());
  }

  void a_terminal_gets_a_bar_and_a_file_does_not() {
    if (!terminals_are_possible()) QSKIP("there are no pseudo-terminals here");
    QProcess terminal;
    terminal.start("script", {"-qec", TROCAR_BINARY " workspace --csv /dev/null", "/dev/null"});
    QVERIFY(terminal.waitForFinished(60'000));
    const QByteArray shown = terminal.readAllStandardOutput();
    QVERIFY2(shown.contains("sampling the workspace  ["), shown);
    QVERIFY(!run_trocar(QStringList{"workspace"} + quick).err.contains("sampling"));
  }
};

QTEST_GUILESS_MAIN(TestWorkspaceCommand)
#include "tst_workspace_command.moc"
