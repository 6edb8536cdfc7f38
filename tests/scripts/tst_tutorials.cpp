// SPDX-License-Identifier: Apache-2.0
// Each tutorial prints what its last comment says: the command is on the line that begins with
// "--   trocar", the lines of its output are marked with "-->".
#include <QDir>
#include <QRegularExpression>
#include <QTest>

#include "tests/cli/trocar_process.hpp"

using namespace trocar::test;

class TestTutorials : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_prints_what_it_says_data() {
    QTest::addColumn<QString>("path");
    const QDir folder(TROCAR_SOURCE_DIR "/scripts/tutorial");
    for (const QString& name :
         folder.entryList({"*.lua"}).filter(QRegularExpression("(?<!tutorials_spec)\\.lua$")))
      QTest::newRow(qPrintable(name)) << folder.filePath(name);
  }
  void it_prints_what_it_says() {
    QFETCH(QString, path);
    QFile file(path);
    QVERIFY(file.open(QFile::ReadOnly));
    QStringList command, marked;
    for (QString line : QString::fromUtf8(file.readAll()).split('\n')) {
      if (line.startsWith("--   trocar ")) command = line.simplified().split(' ').mid(2);
      if (line.startsWith("--> ")) marked << line.mid(4);
    }
    QVERIFY2(!command.isEmpty() && !marked.isEmpty(), "it does not say what it prints");
    QDir::setCurrent(TROCAR_SOURCE_DIR);
    const Ran ran = run_trocar(command);
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.status, 0);
    const QStringList printed = QString::fromUtf8(ran.out).split('\n');
    qsizetype at = 0;
    for (const QString& line : marked) {
      at = printed.indexOf(line, at) + 1;
      QVERIFY2(at > 0, qPrintable("\"" + line + "\" is not, or not there, in\n" + ran.out));
    }
  }

  void the_widest_line_fits_a_terminal() {
    QDir::setCurrent(TROCAR_SOURCE_DIR);
    const Ran ran = run_trocar(
        {"run", "scripts/tutorial/01_feel_a_wall.lua", "--for", "5s", "--clock", "simulated"});
    for (const QString& line : QString::fromUtf8(ran.out).split('\n'))
      QVERIFY2(line.size() <= 80, qPrintable(line));
  }
};

QTEST_GUILESS_MAIN(TestTutorials)
#include "tst_tutorials.moc"
