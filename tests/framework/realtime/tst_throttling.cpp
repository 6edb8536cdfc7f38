// SPDX-License-Identifier: Apache-2.0
#include "framework/realtime/throttling.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using trocar::real_time_share;
using trocar::throttling;

class TestThrottling : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_share_is_what_the_kernel_says_data() {
    QTest::addColumn<QByteArray>("runtime");  // "" where there is no such file
    QTest::addColumn<QByteArray>("period");
    QTest::addColumn<double>("share");
    const auto row = [](const char* name, const char* runtime, const char* period, double share) {
      QTest::newRow(name) << QByteArray(runtime) << QByteArray(period) << share;
    };
    row("Linux's own setting", "950000\n", "1000000\n", 0.95);
    row("no limit", "-1\n", "1000000\n", 1.0);
    row("all of it", "1000000\n", "1000000\n", 1.0);
    row("no such files", "", "", 1.0);
    row("something else", "yes\n", "no\n", 1.0);
  }
  void the_share_is_what_the_kernel_says() {
    QFETCH(QByteArray, runtime);
    QFETCH(QByteArray, period);
    QFETCH(double, share);
    const QTemporaryDir folder;
    const auto put = [&](const char* name, const QByteArray& text) {
      QFile file(folder.filePath(name));
      return text.isEmpty() || (file.open(QFile::WriteOnly) && file.write(text) == text.size());
    };
    QVERIFY(put("sched_rt_runtime_us", runtime) && put("sched_rt_period_us", period));
    QCOMPARE(real_time_share(folder.path().toStdString()), share);
  }

  void a_loop_that_takes_too_much_is_told_data() {
    QTest::addColumn<double>("busy");
    QTest::addColumn<double>("share");
    QTest::addColumn<bool>("told");
    QTest::newRow("half of a processor") << 0.5 << 0.95 << false;
    QTest::newRow("nearly all of it") << 0.94 << 0.95 << true;
    QTest::newRow("where there is no limit") << 1.0 << 1.0 << false;
  }
  void a_loop_that_takes_too_much_is_told() {
    QFETCH(double, busy);
    QFETCH(double, share);
    QFETCH(bool, told);
    const QString text = QString::fromStdString(throttling(busy, share));
    QCOMPARE(!text.isEmpty(), told);
    if (told) QVERIFY2(text.contains("94 %") && text.contains("95 %"), qPrintable(text));
  }
};

QTEST_APPLESS_MAIN(TestThrottling)
#include "tst_throttling.moc"
