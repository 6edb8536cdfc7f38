// SPDX-License-Identifier: Apache-2.0
#include "components/sources/constant.hpp"

#include <QTest>

#include "tests/support/graph_bench.hpp"

using namespace trocar;
using namespace trocar::test;

class TestConstant : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void by_itself_data() {
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("signature");
    QTest::addColumn<QVector<double>>("numbers");
    QTest::newRow("a number is dimensionless") << "3"
                                               << "double [1]" << QVector<double>{3};
    QTest::newRow("a quantity has its unit") << "3 mm"
                                             << "double [m]" << QVector<double>{3e-3};
    QTest::newRow("three are a vector") << "1 N, 0, 3 N"
                                        << "Vector3 [N]" << QVector<double>{1, 0, 3};
    QTest::newRow("the first with a unit says it") << "0, 2 kN, 0"
                                                   << "Vector3 [N]" << QVector<double>{0, 2000, 0};
  }
  void by_itself() {
    QFETCH(QString, value);
    QFETCH(QString, signature);
    QFETCH(QVector<double>, numbers);
    GraphBench bench;
    const NodeId constant =
        bench.add("Constant", {{"value", literal_from_text(value.toStdString())}});
    QCOMPARE(bench.wire(), std::string());
    QCOMPARE(QString::fromStdString(bench.output(constant, "value").signature()->text()),
             signature);
    for (qsizetype i = 0; i < numbers.size(); ++i)
      QCOMPARE(bench.number(constant, "value", static_cast<std::size_t>(i)), numbers[i]);
    bench.tick(3);
    QCOMPARE(bench.number(constant, "value"), numbers.front());
  }

  void into_a_wall_data() {
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("says");  // "" when it is taken
    QTest::newRow("a list with units") << "1 mm, 2 mm, 3 mm"
                                       << "";
    QTest::newRow("a zero needs no unit") << "0, 0, 3 mm"
                                          << "";
    QTest::newRow("all zeros take the unit of the wall") << "0, 0, 0"
                                                         << "";
    QTest::newRow("a bare number needs one") << "0, 0, 3"
                                             << "needs a quantity in m, e.g. \"1 m\"";
    QTest::newRow("another unit") << "0, 0, 3 N"
                                  << "\"3 N\": needs a quantity in m";
    QTest::newRow("too few") << "{1 mm, 2 mm}"
                             << "needs a list of 3 values";
    QTest::newRow("a single number") << "3 mm"
                                     << "needs a list of 3 values";
    QTest::newRow("no unit that there is") << "0, 0, 3 foo"
                                           << "\"foo\" is no unit";
    QTest::newRow("no finite number") << "0, 0, nan m"
                                      << "\"nan m\" is no quantity";
  }
  void into_a_wall() {
    QFETCH(QString, value);
    QFETCH(QString, says);
    GraphBench bench;
    const NodeId position =
        bench.add("Constant", {{"value", literal_from_text(value.toStdString())}}, "position");
    const NodeId velocity =
        bench.add("Constant", {{"value", literal_from_text("0, 0, 0")}}, "velocity");
    const NodeId wall = bench.add("Wall");
    bench.connect(position, "value", wall, "position");
    bench.connect(velocity, "value", wall, "velocity");
    const std::string report = bench.wire();
    if (says.isEmpty()) QCOMPARE(report, std::string());
    QVERIFY2(QString::fromStdString(report).contains(says), report.c_str());
  }

  void a_text_that_is_no_quantity_is_named() {
    GraphBench bench;
    bench.add("Constant", {{"value", {"three"}}});
    const std::string report = bench.wire();
    QVERIFY2(report.find("\"three\" is no quantity") != std::string::npos, report.c_str());
  }
};

QTEST_APPLESS_MAIN(TestConstant)
#include "tst_constant.moc"
