// SPDX-License-Identifier: Apache-2.0
#include <QTest>

#include "tests/support/graph_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

FeedSettings vector(double x, double y, double z, std::string_view unit,
                    const SignalQuality& quality = {}) {
  return {vector_in(unit),
          [=](double, auto v) {
            v[0] = x;
            v[1] = y;
            v[2] = z;
          },
          quality};
}
FeedSettings number(double value, std::string_view unit, const SignalQuality& quality = {}) {
  return {real_in(unit), [=](double, auto v) { v[0] = value; }, quality};
}

}  // namespace

class TestArithmetic : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sum_adds_and_takes_off() {
    GraphBench bench;
    const NodeId sum = bench.add("Sum");
    bench.connect(bench.feed(vector(1, 2, 3, "N")), "value", sum, "terms");
    bench.connect(bench.feed(vector(10, 20, 30, "N")), "value", sum, "terms");
    bench.connect(bench.feed(vector(0.5, 0, -0.5, "N")), "value", sum, "minus");
    QCOMPARE(bench.wire(), std::string());
    bench.tick();
    QCOMPARE(bench.number(sum, "value", 0), 10.5);
    QCOMPARE(bench.number(sum, "value", 1), 22.0);
    QCOMPARE(bench.number(sum, "value", 2), 33.5);
    QCOMPARE(bench.output(sum, "value").signature()->text(), std::string("Vector3 [N] in device"));
  }

  void sum_is_as_late_as_its_latest_and_as_coarse_as_all() {
    GraphBench bench;
    const NodeId sum = bench.add("Sum");
    bench.connect(bench.feed(number(1, "m", {1e-3, {1e-6}})), "value", sum, "terms");
    bench.connect(bench.feed(number(1, "m", {4e-3, {2e-6}})), "value", sum, "terms");
    bench.connect(bench.feed(number(1, "m", {2e-3, {4e-6}})), "value", sum, "minus");
    QCOMPARE(bench.wire(), std::string());
    const SignalQuality& quality = bench.output(sum, "value").quality;
    QCOMPARE(quality.delay, 4e-3);
    QVERIFY(std::abs(quality.resolution.at(0) - 7e-6) < 1e-15);
  }

  void sum_of_different_units_is_refused_data() {
    QTest::addColumn<QString>("second");  // the input of the newtons
    QTest::newRow("two terms") << "terms";
    QTest::newRow("a term and what is taken off") << "minus";
  }
  void sum_of_different_units_is_refused() {
    QFETCH(QString, second);
    GraphBench bench;
    const NodeId sum = bench.add("Sum");
    bench.connect(bench.feed(number(1, "m")), "value", sum, "terms");
    bench.connect(bench.feed(number(1, "N")), "value", sum, second.toStdString());
    const std::string report = bench.wire();
    QVERIFY2(report.find("[N] cannot go where [m] is needed") != report.npos, report.c_str());
  }

  void what_goes_in_and_what_is_asked_for_must_agree() {
    GraphBench bench;
    const NodeId sum = bench.add("Sum");
    const NodeId wall = bench.add("Wall");
    bench.connect(sum, "value", wall, "offset");  // asks for [m]
    bench.connect(bench.feed(number(1, "N")), "value", sum, "terms");
    const std::string report = bench.wire();
    QVERIFY2(report.find("sum.value → wall.offset: [N] cannot go where [m]") != report.npos,
             report.c_str());
  }

  void scale_multiplies_value_unit_and_resolution() {
    GraphBench bench;
    const NodeId scale = bench.add("Scale", {{"factor", {"-2 N/mm"}}});
    bench.connect(bench.feed(vector(1e-3, 0, 2e-3, "m", {1e-3, {1e-6, 1e-6, 2e-6}})), "value",
                  scale, "input");
    QCOMPARE(bench.wire(), std::string());
    bench.tick();
    QVERIFY(std::abs(bench.number(scale, "value", 0) - -2.0) < 1e-12);
    QVERIFY(std::abs(bench.number(scale, "value", 2) - -4.0) < 1e-12);
    const OutputPort& value = bench.output(scale, "value");
    QCOMPARE(value.signature()->text(), std::string("Vector3 [N] in device"));
    QVERIFY(std::abs(value.quality.resolution.at(2) - 4e-3) < 1e-12);
    QCOMPARE(value.quality.delay, 1e-3);
  }

  void scale_asks_backwards_for_the_unit_that_fits() {
    GraphBench bench;
    const NodeId constant = bench.add("Constant", {{"value", {"3 N"}}});
    const NodeId scale = bench.add("Scale", {{"factor", {"0.1 mm/N"}}});
    const NodeId wall = bench.add("Wall");
    bench.connect(constant, "value", scale, "input");
    bench.connect(scale, "value", wall, "offset");
    bench.connect(bench.feed(vector(0, 0, 0, "m")), "value", wall, "position");
    bench.connect(bench.feed(vector(0, 0, 0, "m/s")), "value", wall, "velocity");
    QCOMPARE(bench.wire(), std::string());
    bench.tick();
    QVERIFY(std::abs(bench.number(scale, "value") - 0.3e-3) < 1e-15);
  }

  void product_multiplies_values_and_units() {
    GraphBench bench;
    const NodeId product = bench.add("Product");
    bench.connect(bench.feed(number(3, "N/m")), "value", product, "factor");
    bench.connect(bench.feed(vector(1, 2, 4, "m")), "value", product, "input");
    QCOMPARE(bench.wire(), std::string());
    bench.tick();
    QCOMPARE(bench.number(product, "value", 2), 12.0);
    QCOMPARE(bench.output(product, "value").signature()->text(),
             std::string("Vector3 [N] in device"));
  }

  void product_of_two_vectors_is_refused() {
    GraphBench bench;
    const NodeId product = bench.add("Product");
    bench.connect(bench.feed(vector(1, 2, 4, "m")), "value", product, "factor");
    bench.connect(bench.feed(vector(1, 2, 4, "m")), "value", product, "input");
    const std::string report = bench.wire();
    QVERIFY2(report.find("needs a single number") != report.npos, report.c_str());
  }

  void rotations_are_refused_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<QString>("input");
    QTest::newRow("Sum") << "Sum"
                         << "terms";
    QTest::newRow("Scale") << "Scale"
                           << "input";
    QTest::newRow("Difference") << "Difference"
                                << "position";
    QTest::newRow("Foaw") << "Foaw"
                          << "position";
  }
  void rotations_are_refused() {
    QFETCH(QString, type);
    QFETCH(QString, input);
    GraphBench bench;
    const Signature pose{&type_info<Pose>(), 0, {parse_unit("m"), parse_unit("")}, "device"};
    GraphBench::Settings settings;
    if (type == "Scale") settings = {{"factor", {2.0}}};
    const NodeId node = bench.add(type.toStdString(), settings);
    bench.connect(bench.feed({pose, [](double, auto) {}}), "value", node, input.toStdString());
    const std::string report = bench.wire();
    QVERIFY2(report.find("a rotation cannot be added or scaled") != report.npos, report.c_str());
  }
};

QTEST_APPLESS_MAIN(TestArithmetic)
#include "tst_arithmetic.moc"
