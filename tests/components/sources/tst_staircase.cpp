// SPDX-License-Identifier: Apache-2.0
#include "components/sources/staircase.hpp"

#include <QTest>

#include "tests/support/graph_bench.hpp"

using namespace trocar;
using namespace trocar::test;

class TestStaircase : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void goes_up_down_and_back_data() {
    QTest::addColumn<int>("levels");
    QTest::addColumn<QVector<int>>("course");
    QTest::newRow("3 levels") << 3 << QVector<int>{0, 1, 0, -1, 0};
    QTest::newRow("5 levels") << 5 << QVector<int>{0, 1, 2, 1, 0, -1, -2, -1, 0};
    QTest::newRow("9 levels") << 9 << QVector<int>{0,  1,  2,  3,  4,  3,  2,  1, 0,
                                                   -1, -2, -3, -4, -3, -2, -1, 0};
  }
  void goes_up_down_and_back() {
    QFETCH(int, levels);
    QFETCH(QVector<int>, course);
    const LoadCourse staircase{
        .peak = 18.0, .levels = levels, .duration = static_cast<double>(course.size())};
    QCOMPARE(staircase.dwells(), static_cast<int>(course.size()));
    for (int dwell = 0; dwell < staircase.dwells(); ++dwell) {
      const auto [load, settled] = staircase.at(dwell + 0.9);
      QCOMPARE(load, 18.0 / ((levels - 1) / 2) * course[dwell]);
      QVERIFY(settled);
    }
  }

  void moves_without_a_jump_and_within_its_ramp() {
    const LoadCourse staircase{.peak = 18.0, .levels = 9, .duration = 17.0, .ramp = 0.2};
    double before = 0.0;
    for (int ms = 0; ms <= 17100; ++ms) {
      const auto [load, settled] = staircase.at(1e-3 * ms);
      QVERIFY2(std::abs(load - before) < 0.036, qPrintable(QString::number(ms)));
      before = load;
      if (ms % 1000 > 200) QVERIFY(std::abs(load - 4.5 * staircase.level(ms / 1000)) < 1e-9);
      if (ms % 1000 < 749) QVERIFY(!settled);
    }
    QVERIFY(std::abs(staircase.at(1.1).load - 2.25) < 1e-12);  // half way
  }

  void is_nothing_before_and_after() {
    const LoadCourse staircase{.peak = 18.0, .levels = 3, .duration = 5.0, .ramp = 0.0};
    QCOMPARE(staircase.at(-1.0).load, 0.0);
    QCOMPARE(staircase.at(5.0).load, 0.0);
    QVERIFY(!staircase.at(6.0).settled);
    QCOMPARE(staircase.at(1.0).load, 18.0);
  }

  void loads_along_its_axis_only() {
    GraphBench bench;
    const NodeId staircase = bench.add(
        "Staircase",
        {{"peak", {"18 N"}}, {"levels", {3.0}}, {"axis", {"y"}}, {"duration", {"0.5 s"}}});
    QCOMPARE(bench.wire(), std::string());
    bench.tick(391);  // the end of the fourth dwell, at -18 N
    QCOMPARE(bench.number(staircase, "force", 0), 0.0);
    QCOMPARE(bench.number(staircase, "force", 1), -18.0);
    QCOMPARE(bench.number(staircase, "force", 2), 0.0);
    QCOMPARE(bench.number(staircase, "load"), -18.0);
    QVERIFY(*reinterpret_cast<const bool*>(bench.output(staircase, "settled").data()));
  }

  void hangs_on_the_tool_and_not_on_the_motors() {
    const Staircase staircase;
    QVERIFY(staircase.placement().has_value());
    QCOMPARE(staircase.placement()->acts, Placement::Acts::on_tool);
  }

  void an_even_number_of_levels_is_refused() {
    GraphBench bench;
    bench.add("Staircase", {{"peak", {"18 N"}}, {"levels", {8.0}}});
    const std::string report = bench.wire();
    QVERIFY2(report.find("levels = 8: needs an odd number") != std::string::npos, report.c_str());
    QVERIFY2(report.find("take 7 or 9") != std::string::npos, report.c_str());
  }
};

QTEST_APPLESS_MAIN(TestStaircase)
#include "tst_staircase.moc"
