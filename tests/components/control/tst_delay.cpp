// SPDX-License-Identifier: Apache-2.0
#include "components/control/delay.hpp"

#include <QTest>

#include "tests/support/graph_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

/// Counts the ticks: 0 at tick 0, 1 at tick 1, …
FeedSettings counter(const SignalQuality& quality = {}) {
  return {real_in("m"), [](double t, auto v) { v[0] = std::round(1e3 * t); }, quality};
}

}  // namespace

class TestDelay : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void is_late_by_its_ticks_data() {
    QTest::addColumn<int>("ticks");
    QTest::addColumn<bool>("declared_first");  // before its producer
    for (const bool first : {true, false})
      for (const int ticks : {1, 2, 7})
        QTest::addRow("%d ticks, declared %s its producer", ticks, first ? "before" : "after")
            << ticks << first;
  }
  void is_late_by_its_ticks() {
    QFETCH(int, ticks);
    QFETCH(bool, declared_first);
    GraphBench bench;
    const GraphBench::Settings settings = {{"ticks", {1.0 * ticks}}, {"initial", {"-5 m"}}};
    NodeId delay = declared_first ? bench.add("Delay", settings) : 0;
    const NodeId source = bench.feed(counter());
    if (!declared_first) delay = bench.add("Delay", settings);
    bench.connect(source, "value", delay, "input");
    QCOMPARE(bench.wire(), std::string());
    for (int tick = 0; tick < 20; ++tick) {
      bench.tick();
      QCOMPARE(bench.number(delay, "value"), tick < ticks ? -5.0 : tick - ticks);
    }
  }

  void a_chain_adds_up() {
    GraphBench bench;
    const NodeId last = bench.add("Delay", {{"initial", {0.0}}}, "last");
    const NodeId first = bench.add("Delay", {{"initial", {0.0}}, {"ticks", {2.0}}}, "first");
    const NodeId source = bench.feed(counter());
    bench.connect(source, "value", first, "input");
    bench.connect(first, "value", last, "input");
    QCOMPARE(bench.wire(), std::string());
    bench.tick(11);
    QCOMPARE(bench.number(last, "value"), 7.0);
  }

  /// y_k = x_k + y_{k-n}: with x = 1 the sum grows by one every n ticks.
  void closes_a_loop_data() {
    QTest::addColumn<int>("ticks");
    QTest::newRow("1 tick") << 1;
    QTest::newRow("3 ticks") << 3;
  }
  void closes_a_loop() {
    QFETCH(int, ticks);
    GraphBench bench;
    const NodeId one = bench.feed({real_in("N"), [](double, auto v) { v[0] = 1.0; }});
    const NodeId sum = bench.add("Sum");
    const NodeId delay = bench.add("Delay", {{"initial", {0.0}}, {"ticks", {1.0 * ticks}}});
    bench.connect(one, "value", sum, "terms");
    bench.connect(delay, "value", sum, "terms");
    bench.connect(sum, "value", delay, "input");
    QCOMPARE(bench.wire(), std::string());
    for (int tick = 0; tick < 12; ++tick) {
      bench.tick();
      QCOMPARE(bench.number(sum, "value"), 1.0 + tick / ticks);
    }
  }

  void two_in_a_ring_swap_their_values() {
    GraphBench bench;
    const NodeId a = bench.add("Delay", {{"initial", {"1 N"}}}, "a");
    const NodeId b = bench.add("Delay", {{"initial", {"2 N"}}}, "b");
    bench.connect(a, "value", b, "input");
    bench.connect(b, "value", a, "input");
    QCOMPARE(bench.wire(), std::string());
    for (int tick = 0; tick < 6; ++tick) {
      bench.tick();
      QCOMPARE(bench.number(a, "value"), tick % 2 == 0 ? 1.0 : 2.0);
      QCOMPARE(bench.number(b, "value"), tick % 2 == 0 ? 2.0 : 1.0);
    }
  }

  void states_the_quality_of_its_producer() {
    GraphBench bench;
    const NodeId delay = bench.add("Delay", {{"initial", {0.0}}, {"ticks", {3.0}}});
    const NodeId source = bench.feed(counter({.delay = 2e-3, .resolution = {1e-6}}));
    bench.connect(source, "value", delay, "input");
    QCOMPARE(bench.wire(), std::string());
    const SignalQuality& quality = bench.output(delay, "value").quality;
    QVERIFY(std::abs(quality.delay - 5e-3) < 1e-12);
    QCOMPARE(quality.resolution, std::vector<double>{1e-6});
  }

  void an_initial_value_in_another_unit_is_refused() {
    GraphBench bench;
    const NodeId source = bench.feed(counter());
    const NodeId delay = bench.add("Delay", {{"initial", {"0.1 N"}}});
    bench.connect(source, "value", delay, "input");
    const std::string report = bench.wire();
    QVERIFY2(report.find("initial = \"0.1 N\": needs a quantity in m") != report.npos,
             report.c_str());
  }
};

QTEST_APPLESS_MAIN(TestDelay)
#include "tst_delay.moc"
