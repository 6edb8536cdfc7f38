// SPDX-License-Identifier: Apache-2.0
// `trocar graph` as users call it, and the pictures in the documents that come from it.
#include <QDir>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/trocar_process.hpp"

using namespace trocar::test;

namespace {

QString content(const QString& path) {
  QFile file(path);
  return file.open(QFile::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

class TestGraphCommand : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(TROCAR_SOURCE_DIR)); }

  void it_answers_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("out");  // how it begins; "" for nothing at all
    QTest::addColumn<QByteArray>("err");  // a part of it
    const auto row = [](const char* name, const QStringList& arguments, int status, const char* out,
                        const char* err) {
      QTest::newRow(name) << (QStringList{"graph"} + arguments) << status << QByteArray(out)
                          << QByteArray(err);
    };
    const QString wall = "scripts/tutorial/01_feel_a_wall.lua";
    row("dot, when nobody says", {wall}, 0, "digraph trocar {\n", "");
    row("dot", {wall, "--format", "dot"}, 0, "digraph trocar {\n", "");
    row("mermaid", {wall, "--format", "mermaid"}, 0, "flowchart LR\n", "");
    row("json", {wall, "--format=json"}, 0, "{\n  \"threads\": [\n", "");
    row("a script that runs its graph itself, which it does not",
        {"scripts/tutorial/02_incision.lua"}, 0, "digraph trocar {\n", "");
    row("another format", {wall, "--format", "svg"}, 2, "", "svg not in {dot,json,mermaid}");
    row("a broken script", {"tests/data/ten_mistakes.lua"}, 2, "", "tests/data/ten_mistakes.lua:");
    row("a script that does not exist", {"none.lua"}, 2, "", "there is no script that can be read");
    row("a setting that names nothing", {wall, "--set", "wal.stiffness=1"}, 2, "",
        "did you mean \"wall.stiffness\"?");
    row("a file that cannot be written", {wall, "-o", "/nowhere/graph.dot"}, 1, "",
        "trocar: cannot write \"/nowhere/graph.dot\"");
  }
  void it_answers() {
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    QFETCH(QByteArray, out);
    QFETCH(QByteArray, err);
    const Ran ran = run_trocar(arguments);
    QCOMPARE(ran.status, status);
    QVERIFY2(ran.out.startsWith(out) && ran.out.isEmpty() == out.isEmpty(), ran.out);
    QVERIFY2(ran.err.contains(err) && ran.err.isEmpty() == err.isEmpty(), ran.err);
  }

  void the_rate_is_that_of_the_scripts_first_run() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("fast.lua");
    QFile file(path);
    QVERIFY(file.open(QFile::WriteOnly));
    file.write(
        "trocar.Constant { value = 1, rate = \"2 kHz\" }\ntrocar.run { rate = \"4 kHz\" }\n");
    file.close();
    const Ran checked = run_trocar({"check", path});
    QVERIFY2(checked.status == 0, checked.out);
    QCOMPARE(run_trocar({"graph", path}).status, 0);
  }

  void mistakes_are_those_of_check() {
    const QByteArray checked = run_trocar({"check", "tests/data/ten_mistakes.lua"}).out;
    const QByteArray drawn = run_trocar({"graph", "tests/data/ten_mistakes.lua"}).err;
    for (const QByteArray& line : checked.split('\n'))
      if (line.startsWith("tests/")) QVERIFY2(drawn.contains(line), line);
  }

  void a_file_gets_what_standard_output_would() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("graph.json");
    const QStringList draw = {"graph", "scripts/tutorial/03_tilted.lua", "--format", "json"};
    const Ran to_file = run_trocar(draw + QStringList{"--output", file});
    QCOMPARE(to_file.status, 0);
    QCOMPARE(to_file.out, QByteArray());
    QCOMPARE(content(file), QString::fromUtf8(run_trocar(draw).out));
    QVERIFY(!QJsonDocument::fromJson(content(file).toUtf8()).isNull());
  }

  void a_setting_is_drawn() {
    const Ran ran = run_trocar({"graph", "scripts/tutorial/02_incision.lua", "--format", "mermaid",
                                "--set", "staircase.peak=7 N"});
    QVERIFY2(ran.out.contains("peak = 7 N"), ran.out);
  }

  /// Between "<!-- graph: begin. From `COMMAND` -->" and "<!-- graph: end -->" stands what the
  /// command prints, between ```mermaid and ```.
  void a_document_shows_what_the_command_prints_data() {
    QTest::addColumn<QString>("path");
    QTest::newRow("README") << "README.md";
    QTest::newRow("architecture") << "docs/architecture.md";
  }
  void a_document_shows_what_the_command_prints() {
    QFETCH(QString, path);
    static const QRegularExpression shown(
        "<!-- graph: begin\\. From `build/bin/trocar ([^`]*)` -->\n```mermaid\n(.*?)```\n"
        "<!-- graph: end -->",
        QRegularExpression::DotMatchesEverythingOption);
    const QString text = content(path);
    int pictures = 0;
    for (auto each = shown.globalMatch(text); each.hasNext(); ++pictures) {
      const QRegularExpressionMatch picture = each.next();
      const Ran ran = run_trocar(picture.captured(1).split(' '));
      QCOMPARE(ran.err, QByteArray());
      QCOMPARE(picture.captured(2), QString::fromUtf8(ran.out));
    }
    QVERIFY(pictures > 0);
    QCOMPARE(pictures, text.count("<!-- graph: begin"));
  }
};

QTEST_GUILESS_MAIN(TestGraphCommand)
#include "tst_graph_command.moc"
