// SPDX-License-Identifier: Apache-2.0
#include "framework/highlights.hpp"

#include <QTest>
#include <cmath>

#include "tests/support/run_rig.hpp"

using namespace trocar;
using test::RunRig;

class TestHighlights : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_force_at_a_site_has_its_peak_and_its_end() {
    RunRig rig;
    Highlights highlights;
    rig.run(0.1, {&highlights});
    QCOMPARE(highlights.all().size(), std::size_t{1});
    const Highlight& force = highlights.all()[0];
    QCOMPARE(force.name, std::string("meter.force"));
    QCOMPARE(force.unit, std::string("N"));
    QVERIFY(force.is_force);
    QCOMPARE(force.peak, 99.0 * std::sqrt(6.0));
    QCOMPARE(force.peak_time, 0.099);
    QCOMPARE(force.at_peak.y, 198.0);
    QCOMPARE(force.last.z, -99.0);
  }

  void a_peak_is_not_lost_to_what_is_no_number() {
    RunRig rig;
    rig.graph.set({rig.meter, "broken_from"}, literal_from_text("20"), {"test", 3});
    Highlights highlights;
    rig.run(0.1, {&highlights});
    QCOMPARE(highlights.all()[0].peak, 19.0 * std::sqrt(6.0));
    QCOMPARE(highlights.all()[0].peak_time, 0.019);
  }

  void moments_are_few_even_and_end_with_the_last_row_data() {
    QTest::addColumn<int>("rows");
    for (const int rows : {1, 2, 23, 24, 25, 48, 1000, 12'345})
      QTest::newRow(QByteArray::number(rows) + " rows") << rows;
  }
  void moments_are_few_even_and_end_with_the_last_row() {
    QFETCH(int, rows);
    RunRig rig;
    Highlights highlights;
    rig.run(rows * 1e-3, {&highlights});
    const std::vector<Highlights::Moment> moments = highlights.moments();
    QVERIFY(moments.size() <= 25);
    QVERIFY(static_cast<int>(moments.size()) >= std::min(rows, 12));
    QCOMPARE(moments.front().time, 0.0);
    QCOMPARE(moments.back().time, (rows - 1) * 1e-3);
    for (std::size_t i = 2; i + 1 < moments.size(); ++i)
      QVERIFY(std::abs(moments[i].time - 2 * moments[i - 1].time + moments[i - 2].time) < 1e-9);
    for (const Highlights::Moment& moment : moments)
      QVERIFY(std::abs(moment.values[0].x - moment.time * 1e3) < 1e-6);
  }
};

QTEST_APPLESS_MAIN(TestHighlights)
#include "tst_highlights.moc"
