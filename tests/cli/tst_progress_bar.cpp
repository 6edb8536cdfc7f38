// SPDX-License-Identifier: Apache-2.0
#include "cli/progress_bar.hpp"

#include <QTest>

using trocar::cli::bar_text;
using trocar::cli::ProgressBar;

class TestProgressBar : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_fills_up_data() {
    QTest::addColumn<int>("done");
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("filled");
    QTest::addColumn<QString>("percent");
    QTest::newRow("nothing yet") << 0 << 8 << 0 << "  0 %";
    QTest::newRow("a part") << 2 << 8 << 10 << " 25 %";
    QTest::newRow("almost all is not all") << 999 << 1000 << 39 << " 99 %";
    QTest::newRow("all") << 8 << 8 << 40 << "100 %";
    QTest::newRow("of nothing") << 0 << 0 << 40 << "100 %";
  }
  void it_fills_up() {
    QFETCH(int, done);
    QFETCH(int, count);
    QFETCH(int, filled);
    QFETCH(QString, percent);
    const QString bar = QString::fromStdString(
        bar_text("work", static_cast<std::size_t>(done), static_cast<std::size_t>(count)));
    QCOMPARE(bar, "work  [" + QString("#").repeated(filled) + QString(" ").repeated(40 - filled) +
                      "] " + percent);
  }
};

QTEST_APPLESS_MAIN(TestProgressBar)
#include "tst_progress_bar.moc"
