// SPDX-License-Identifier: Apache-2.0
// `trocar test` as users call it.
#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/cli/trocar_process.hpp"

using namespace trocar::test;

class TestTestCommand : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;

  void write(const QString& name, const QByteArray& text) {
    const QString path = folder_.filePath(name);
    QVERIFY(QDir().mkpath(QFileInfo(path).path()));
    QFile file(path);
    QVERIFY(file.open(QFile::WriteOnly) && file.write(text) == text.size());
  }
  static QStringList headlines(const QByteArray& out) {
    QStringList lines;
    for (const QString& line : QString::fromUtf8(out).split('\n'))
      if (line.startsWith("  passed") || line.startsWith("  FAILED"))
        lines << line.section("  (", 0, 0);
    return lines;
  }

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(QDir::setCurrent(folder_.path()));
    write("good/a_spec.lua",
          "it('one', function() expect(1):equals(1) end)\n"
          "it('two', function() expect(2):equals(2) end)\n");
    write("good/deep/b_spec.lua", "it('three', function() expect(3):equals(3) end)\n");
    write("good/no_test.lua", "error('this is no spec')\n");
    write("mixed/c_spec.lua",
          "it('wrong <&\"', function() print('said', 7) expect(1):equals(2) end)\n"
          "it('dies', function() os.execute('kill -ABRT $PPID') end)\n"
          "it('hangs', function() while true do end end)\n"
          "it('right', function() expect(1):equals(1) end)\n");
    write("broken/d_spec.lua", "it('four', function() expect(1):equals(1) end)\n");
    write("broken/e_spec.lua", "\nerror('broken')\n");
    QVERIFY(QDir().mkpath(folder_.filePath("empty")));
  }

  void it_runs_all_specs_below_a_folder() {
    const Ran ran = run_trocar({"test", "good", "-j", "2"});
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.status, 0);
    QCOMPARE(headlines(ran.out),
             (QStringList{"  passed  one", "  passed  two", "  passed  three"}));
    QVERIFY(ran.out.startsWith("good/a_spec.lua\n"));
    QVERIFY(ran.out.endsWith("3 tests: 3 passed, 0 failed\n"));
  }

  void a_test_that_dies_or_hangs_harms_no_other() {
    const Ran ran = run_trocar({"test", "mixed", "--timeout", "2 s"});
    QCOMPARE(ran.status, 1);
    QCOMPARE(headlines(ran.out), (QStringList{"  FAILED  wrong <&\"", "  FAILED  dies",
                                              "  FAILED  hangs", "  passed  right"}));
    for (const char* text :
         {"c_spec.lua:1\n", "it printed\n      said\t7\n", "the test ended by signal 6 (Aborted)",
          "the test did not end within 2 s", "4 tests: 1 passed, 3 failed"})
      QVERIFY2(ran.out.contains(text), ran.out);
  }

  void a_broken_file_does_not_hide_the_others() {
    const Ran ran = run_trocar({"test", "broken"});
    QCOMPARE(ran.status, 2);
    QCOMPARE(headlines(ran.out), (QStringList{"  passed  four"}));
    QVERIFY2(ran.err.contains("broken/e_spec.lua:2: broken"), ran.err);
  }

  void filters_and_lists() {
    QCOMPARE(headlines(run_trocar({"test", "good", "--filter", "tw"}).out),
             (QStringList{"  passed  two"}));
    QCOMPARE(headlines(run_trocar({"test", "good", "--filter", "b_spec"}).out),
             (QStringList{"  passed  three"}));
    const Ran none = run_trocar({"test", "good", "--filter", "thre e"});
    QCOMPARE(none.status, 2);
    QVERIFY2(none.err.contains("did you mean \"three\"?"), none.err);
    QCOMPARE(run_trocar({"test", "good/deep", "--list"}).out,
             QByteArray("good/deep/b_spec.lua:1: three\n"));
    QCOMPARE(headlines(run_trocar({"test", "good/a_spec.lua", "good/a_spec.lua"}).out).size(), 2);
  }

  void wrong_usage_is_explained_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("err");
    QTest::newRow("no spec") << QStringList{"empty"} << QByteArray("ends with _spec.lua");
    QTest::newRow("no file") << QStringList{"none"} << QByteArray("no file or folder \"none\"");
    QTest::newRow("jobs") << QStringList{"good", "-j", "0"} << QByteArray("--jobs");
    QTest::newRow("timeout") << QStringList{"good", "--timeout", "2 N"}
                             << QByteArray("no duration");
  }
  void wrong_usage_is_explained() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, err);
    const Ran ran = run_trocar(QStringList{"test"} + arguments);
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.contains(err), ran.err);
  }

  void junit_is_read_by_an_xml_reader() {
    const Ran ran = run_trocar({"test", "mixed", "--timeout", "2 s", "--junit", "report.xml"});
    QCOMPARE(ran.status, 1);
    QFile file("report.xml");
    QVERIFY(file.open(QFile::ReadOnly));
    QXmlStreamReader xml(&file);
    QStringList cases, failures;
    QString printed;
    while (!xml.atEnd()) {
      xml.readNext();
      if (!xml.isStartElement()) continue;
      if (xml.name() == QLatin1String("testsuite")) {
        QCOMPARE(xml.attributes().value("tests").toString(), QString("4"));
        QCOMPARE(xml.attributes().value("failures").toString(), QString("3"));
      }
      if (xml.name() == QLatin1String("testcase"))
        cases << xml.attributes().value("name").toString();
      if (xml.name() == QLatin1String("failure"))
        failures << xml.attributes().value("message").toString();
      if (xml.name() == QLatin1String("system-out") && printed.isEmpty())
        printed = xml.readElementText();
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QCOMPARE(cases, (QStringList{"wrong <&\"", "dies", "hangs", "right"}));
    QCOMPARE(failures.size(), 3);
    QCOMPARE(failures.first(), QString("expected 2, got 1"));
    QCOMPARE(printed, QString("said\t7\n"));
  }
};

QTEST_GUILESS_MAIN(TestTestCommand)
#include "tst_test_command.moc"
