// SPDX-License-Identifier: Apache-2.0
#include "components/control/creep.hpp"

#include <QTest>
#include <cmath>

#include "tests/support/graph_bench.hpp"

using namespace trocar;

class TestCreep : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_yields_exponentially_whatever_the_step_data() {
    QTest::addColumn<double>("step");  // [s]
    QTest::newRow("1 ms") << 1e-3;
    QTest::newRow("10 ms") << 1e-2;
    QTest::newRow("as long as the time constant") << 0.5;
    QTest::newRow("longer") << 2.0;
  }
  void it_yields_exponentially_whatever_the_step() {
    QFETCH(double, step);
    Creep creep;
    creep.compliance.set({std::string("0.2 mm/N")});
    creep.time_constant.set({std::string("0.5 s")});
    Output<double> load(&creep, "test_load", {.unit = "N"});
    creep.load.connect({.output = &load});
    *load = 3.0;
    creep.start();
    double time = 0.0;
    for (int k = 0; k < 20; ++k) {
      creep.step({.index = k, .dt = step});
      time += step;
      QVERIFY(std::abs(*creep.depth - 0.6e-3 * (1.0 - std::exp(-time / 0.5))) < 1e-15);
    }
    *load = 0.0;
    const double before = *creep.depth;
    creep.step({.index = 20, .dt = step});
    QVERIFY(std::abs(*creep.depth - before * std::exp(-step / 0.5)) < 1e-15);
  }
};

QTEST_APPLESS_MAIN(TestCreep)
#include "tst_creep.moc"
