// SPDX-License-Identifier: Apache-2.0
#include "framework/recording/file_series.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using trocar::FileSeries;

class TestFileSeries : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void names_count_on_from_the_first_data() {
    QTest::addColumn<QString>("first");
    QTest::addColumn<QStringList>("names");
    QTest::newRow("a name without a number")
        << "touch.mcap" << QStringList{"touch.mcap", "touch-2.mcap", "touch-3.mcap"};
    QTest::newRow("one with its number")
        << "demo.blackbox-1.mcap" << QStringList{"demo.blackbox-1.mcap", "demo.blackbox-2.mcap"};
    QTest::newRow("one without an extension") << "touch" << QStringList{"touch", "touch-2"};
    QTest::newRow("a number that is not the first's")
        << "trial-7.mcap" << QStringList{"trial-7.mcap", "trial-7-2.mcap"};
  }
  void names_count_on_from_the_first() {
    QFETCH(QString, first);
    QFETCH(QStringList, names);
    const QTemporaryDir folder;
    const std::string path = folder.filePath(first).toStdString();
    FileSeries replacing(path, FileSeries::Existing::replaced);
    FileSeries passing(path, FileSeries::Existing::passed_over);
    for (const QString& name : names) {
      QCOMPARE(replacing.next(), folder.filePath(name).toStdString());
      QVERIFY(!QFile::exists(folder.filePath(name)));
      QCOMPARE(passing.next(), folder.filePath(name).toStdString());
      QVERIFY2(QFile::exists(folder.filePath(name)), "it is taken at once");
    }
  }

  void a_file_that_is_there_is_passed_over() {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("trip.mcap").toStdString();
    FileSeries first(path, FileSeries::Existing::passed_over);
    first.next();
    first.next();
    FileSeries second(path, FileSeries::Existing::passed_over);
    QCOMPARE(second.next(), folder.filePath("trip-3.mcap").toStdString());
  }

  void a_folder_that_is_not_there_is_for_the_writer_to_refuse() {
    FileSeries series("/nowhere/at/all.mcap", FileSeries::Existing::passed_over);
    QCOMPARE(series.next(), std::string("/nowhere/at/all.mcap"));
  }
};

QTEST_APPLESS_MAIN(TestFileSeries)
#include "tst_file_series.moc"
