// SPDX-License-Identifier: Apache-2.0
// What the commands do with plugins: those of plugins/example, and some that are refused.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/trocar_process.hpp"

using namespace trocar::test;

namespace {

const QString groove = TROCAR_SOURCE_DIR "/plugins/example/groove.lua";
const QString slider = TROCAR_SOURCE_DIR "/plugins/example/slider.lua";

void write(const QString& name, const QByteArray& text) {
  QFile file(name);
  if (!file.open(QFile::WriteOnly) || file.write(text) != text.size())
    qFatal("%s cannot be written", qPrintable(name));
}

/// The numbers of a published table, by their names.
QMap<QByteArray, double> published(const QByteArray& report, const QByteArray& table) {
  QMap<QByteArray, double> numbers;
  const QList<QByteArray> lines = report.split('\n');
  const auto at = lines.indexOf(table);
  if (at < 0 || at + 2 >= lines.size()) return numbers;
  const QList<QByteArray> names = lines[at + 1].simplified().split(' ');
  const QList<QByteArray> values = lines[at + 2].simplified().split(' ');
  for (qsizetype i = 0; i < names.size() && i < values.size(); ++i)
    numbers[names[i]] = values[i].toDouble();
  return numbers;
}

}  // namespace

class TestPluginsCommand : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { qputenv("TROCAR_PLUGIN_PATH", TROCAR_EXAMPLE_PLUGIN); }

  void plugins_are_listed() {
    const Ran ran = run_trocar({"list", "plugins"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.status, 0);
    for (const char* part :
         {"example 1.0.0: A fixture and a simulated device, to be copied\n",
          "  file        " TROCAR_EXAMPLE_PLUGIN "/example.so\n", "  licence     Apache-2.0\n",
          "  components  Groove, Slider\n", "  " TROCAR_EXAMPLE_PLUGIN " (TROCAR_PLUGIN_PATH)\n",
          "/trocar/plugins\n"})
      QVERIFY2(ran.out.contains(part), part + QByteArray(" is not in\n") + ran.out);
    QCOMPARE(run_trocar({"list", "plugins", "--names"}).out, QByteArray("example\nfoxglove\n"));
  }

  void plugins_are_listed_for_programs() {
    const auto json =
        QJsonDocument::fromJson(run_trocar({"list", "plugins", "--json"}).out).object();
    const QJsonObject example = json["plugins"].toArray().at(0).toObject();
    QCOMPARE(example["name"].toString(), QString("example"));
    QCOMPARE(example["components"].toArray(), (QJsonArray{"Groove", "Slider"}));
    QVERIFY(example["services"].toArray().isEmpty() && json["refused"].toArray().isEmpty());
    QCOMPARE(json["searched"].toArray().size(), 2);
  }

  void none_is_said_to_be_none() {
    qunsetenv("TROCAR_PLUGIN_PATH");
    const Ran ran = run_trocar({"list", "plugins"});
    QCOMPARE(ran.status, 0);
    QVERIFY2(!ran.out.contains("example 1.0.0"), ran.out);
    QVERIFY2(ran.out.contains("Searched, in this order:\n"), ran.out);
  }

  void there_is_no_page_of_plugins() {
    const Ran ran = run_trocar({"list", "plugins", "--markdown"});
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.contains("is for components; take --json"), ran.err);
  }

  void the_page_of_components_is_of_those_built_in() {
    QFile page(TROCAR_SOURCE_DIR "/docs/components.md");
    QVERIFY(page.open(QFile::ReadOnly));
    QVERIFY(run_trocar({"list", "--markdown"}).out == page.readAll());
  }

  void a_component_is_like_any_other() {
    const Ran list = run_trocar({"list"});
    QVERIFY2(list.out.contains("A groove that keeps a point on a line (plugin example)\n"),
             list.out);
    QVERIFY(run_trocar({"list", "--names"}).out.contains("\nGroove\n"));
    const Ran described = run_trocar({"describe", "Groove"});
    QCOMPARE(described.status, 0);
    QVERIFY2(described.out.contains("stiffness  number, 0–5 N/mm"), described.out);
    QCOMPARE(run_trocar({"check", groove}).status, 0);
    QVERIFY(run_trocar({"graph", groove}).out.contains("Groove"));
    const Ran flight = run_trocar({"check", groove, "--preflight"});
    QVERIFY2(flight.status == 0, flight.out + flight.err);
  }

  void a_script_feels_it() {
    const Ran ran = run_trocar({"run", groove, "--clock", "simulated"});
    QVERIFY2(ran.status == 0 && ran.err.isEmpty(), ran.out + ran.err);
    const auto table = published(ran.out, "groove");
    QVERIFY2(table["force"] > 0.1 && qAbs(table["force"] - table["expected"]) < 1e-6, ran.out);
  }

  void a_device_of_it_stands_behind_the_gate() {
    const Ran ran = run_trocar({"run", slider, "--clock", "simulated"});
    QVERIFY2(ran.status == 0 && ran.err.isEmpty(), ran.out + ran.err);
    const auto table = published(ran.out, "slider");
    QVERIFY2(qAbs(table["sent"] - 8.0) < 1e-9 && qAbs(table["scale"] - 2.0 / 3.0) < 1e-5, ran.out);
    QVERIFY(run_trocar({"graph", slider, "--format", "mermaid"}).out.contains("gate-slider"));
  }

  void specs_use_it() {
    const QTemporaryDir folder;
    write(folder.filePath("groove_spec.lua"),
          "it(\"is there\", function()\n"
          "  trocar.Groove { at = trocar.Laparoscope {}.tip }\n"
          "  expect(trocar.run { duration = \"10 ms\" }.faults):empty()\n"
          "end)\n");
    const Ran ran = run_trocar({"test", folder.path()});
    QVERIFY2(ran.status == 0 && ran.err.isEmpty(), ran.out + ran.err);
  }

  void one_that_is_refused_is_a_warning() {
    const QTemporaryDir folder;
    write(folder.filePath("odd.so"), "text");
    const QByteArray warning = "trocar: warning: plugin " + folder.filePath("odd.so").toUtf8() +
                               ": it is no shared library: build one with trocar_plugin() of "
                               "CMake\n";
    qputenv("TROCAR_PLUGIN_PATH", folder.path().toUtf8() + ":" TROCAR_EXAMPLE_PLUGIN);
    for (const QStringList& arguments :
         {QStringList{"list"}, QStringList{"describe", "Groove"}, QStringList{"graph", slider},
          QStringList{"run", slider, "--clock", "simulated"}}) {
      const Ran ran = run_trocar(arguments);
      QCOMPARE(ran.status, 0);
      QCOMPARE(ran.err, warning);
    }
    const Ran list = run_trocar({"list", "plugins"});
    QCOMPARE(list.err, QByteArray());  // it is in the answer
    QVERIFY2(list.out.contains("refused: " + folder.filePath("odd.so").toUtf8() +
                               "\n  it is no shared library: "),
             list.out);
    const auto json =
        QJsonDocument::fromJson(run_trocar({"list", "plugins", "--json"}).out).object();
    QVERIFY(json["refused"].toArray().at(0).toObject()["reasons"].toArray().size() == 1);
  }

  void specs_warn_once() {
    const QTemporaryDir folder;
    write(folder.filePath("odd.so"), "text");
    write(folder.filePath("a_spec.lua"),
          "for _, name in ipairs { \"a\", \"b\" } do\n"
          "  it(name, function() expect(1):equals(1) end)\nend\n");
    qputenv("TROCAR_PLUGIN_PATH", folder.path().toUtf8());
    const Ran ran = run_trocar({"test", folder.path()});
    QCOMPARE(ran.status, 0);
    QCOMPARE(ran.err.count("warning: plugin"), 1);
    QVERIFY2(!ran.out.contains("warning"), ran.out);
  }

  void a_script_that_needs_what_is_missing_is_broken() {
    const QTemporaryDir folder;
    write(folder.filePath("example.so"), "text");
    qputenv("TROCAR_PLUGIN_PATH", folder.path().toUtf8());
    const Ran ran = run_trocar({"run", groove, "--clock", "simulated"});
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.contains("warning: plugin ") && ran.err.contains("no trocar.Groove"), ran.err);
  }
};

QTEST_GUILESS_MAIN(TestPluginsCommand)
#include "tst_plugins_command.moc"
