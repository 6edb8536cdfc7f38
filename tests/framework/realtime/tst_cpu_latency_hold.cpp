// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/cpu_latency_hold.hpp"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using trocar::CpuLatencyHold;

namespace {

/// Whether this process has the file open.
bool is_open(const QString& path) {
  const QFileInfoList all = QDir("/proc/self/fd").entryInfoList(QDir::Files | QDir::System);
  return std::any_of(all.begin(), all.end(),
                     [&](const QFileInfo& one) { return one.symLinkTarget() == path; });
}

}  // namespace

class TestCpuLatencyHold : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_writes_0_us_and_keeps_the_file_open_as_long_as_it_lives() {
    const QTemporaryDir folder;
    QFile file(QDir(folder.path()).canonicalPath() + "/latency");
    QVERIFY(file.open(QFile::WriteOnly));
    file.close();
    {
      const CpuLatencyHold hold(file.fileName().toStdString());
      QVERIFY(hold.held());
      QCOMPARE(hold.shortcoming(), std::string());
      QVERIFY(is_open(file.fileName()));
    }
    QVERIFY(!is_open(file.fileName()));
    QVERIFY(file.open(QFile::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray(4, '\0'));
  }

  void what_cannot_be_held_says_why_and_how_to_allow_it_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("says");
    QTest::newRow("a kernel without it") << "/nowhere/latency"
                                         << "this kernel has no such device";
    QTest::newRow("a file that may not be opened") << "/"
                                                   << "udev rule";
    QTest::newRow("a device that takes nothing") << "/dev/full"
                                                 << "No space left on device";
  }
  void what_cannot_be_held_says_why_and_how_to_allow_it() {
    QFETCH(QString, path);
    QFETCH(QString, says);
    const CpuLatencyHold hold(path.toStdString());
    QVERIFY(!hold.held());
    const QString text = QString::fromStdString(hold.shortcoming());
    QVERIFY2(text.contains(says) && text.contains(path), qPrintable(text));
    QVERIFY(!is_open(path));
  }
};

QTEST_APPLESS_MAIN(TestCpuLatencyHold)
#include "tst_cpu_latency_hold.moc"
