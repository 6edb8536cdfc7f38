// SPDX-License-Identifier: Apache-2.0
#include <QTest>
#include <cmath>
#include <numbers>

#include "components/filters/difference.hpp"
#include "components/filters/foaw.hpp"
#include "tests/support/graph_bench.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

constexpr double count = 1e-6;  // [m] of the encoder
constexpr double period = 1e-3;

double counted(double x) {
  return count * std::floor(x / count);
}

/// Largest error of a filter's velocity against `speed(t)`, from 0.1 s on.
double worst_error(auto& filter, const auto& position, const auto& speed) {
  double worst = 0.0;
  for (int k = 1; k < 2000; ++k) {
    const double v = filter.update(counted(position(k * period)), period);
    if (k > 100) worst = std::max(worst, std::abs(v - speed(k * period)));
  }
  return worst;
}

AdaptiveWindow foaw(AdaptiveWindow::Fit fit, int window = 15) {
  AdaptiveWindow filter({.window = window, .band = count, .fit = fit});
  filter.reset(0.0, period);
  return filter;
}

}  // namespace

class TestVelocity : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void fits_data() {
    QTest::addColumn<int>("fit");
    QTest::newRow("through the ends") << 0;
    QTest::newRow("by least squares") << 1;
  }

  void slow_motion_is_smooth_data() { fits_data(); }
  void slow_motion_is_smooth() {
    QFETCH(int, fit);
    const auto position = [](double t) { return 3.3e-3 * t; };
    const auto speed = [](double) { return 3.3e-3; };
    AdaptiveWindow filter = foaw(static_cast<AdaptiveWindow::Fit>(fit));
    BackwardDifference difference;
    const double of_difference = worst_error(difference, position, speed);
    const double of_window = worst_error(filter, position, speed);
    QVERIFY(of_difference > 0.5e-3);  // the counts: half of one and more in a period
    QVERIFY2(of_window < 1.001 * count / (15 * period), qPrintable(QString::number(of_window)));
  }

  void an_impact_shortens_the_window_data() { fits_data(); }
  void an_impact_shortens_the_window() {
    QFETCH(int, fit);
    AdaptiveWindow filter = foaw(static_cast<AdaptiveWindow::Fit>(fit));
    double v = 0.0;
    for (int k = 1; k <= 100; ++k) v = filter.update(counted(0.1 * k * period), period);
    QVERIFY(std::abs(v - 0.1) < 1e-3);
    const double at_wall = counted(0.1 * 100 * period);
    for (int k = 0; k < 2; ++k) v = filter.update(at_wall, period);
    QVERIFY2(std::abs(v) < 1e-3, qPrintable(QString::number(v)));  // a fixed window: 0.087
  }

  void a_sine_is_followed_data() { fits_data(); }
  void a_sine_is_followed() {
    QFETCH(int, fit);
    const double w = 2.0 * std::numbers::pi * 2.0;
    const auto position = [&](double t) { return 0.02 * std::sin(w * t); };
    const auto speed = [&](double t) { return 0.02 * w * std::cos(w * t); };
    AdaptiveWindow filter = foaw(static_cast<AdaptiveWindow::Fit>(fit));
    const double worst = worst_error(filter, position, speed);
    // Half of the longest window late at the largest acceleration is the bound.
    QVERIFY2(worst < 0.02 * w * w * 7.5 * period, qPrintable(QString::number(worst)));
  }

  void a_flip_of_one_count_is_spread_over_the_window_data() { fits_data(); }
  void a_flip_of_one_count_is_spread_over_the_window() {
    QFETCH(int, fit);
    AdaptiveWindow filter = foaw(static_cast<AdaptiveWindow::Fit>(fit));
    double worst = 0.0;
    for (int k = 0; k < 200; ++k)
      worst = std::max(worst, std::abs(filter.update((k * k) % 7 < 3 ? 0.0 : count, period)));
    QVERIFY2(worst <= count / (15 * period) * (1 + 1e-9), qPrintable(QString::number(worst)));
    QVERIFY(worst > 0.0);
  }

  void uneven_samples_of_a_straight_line_give_its_slope_data() { fits_data(); }
  void uneven_samples_of_a_straight_line_give_its_slope() {
    QFETCH(int, fit);
    AdaptiveWindow filter = foaw(static_cast<AdaptiveWindow::Fit>(fit));
    double t = 0.0, v = 0.0;
    for (int k = 0; k < 60; ++k) {
      const double dt = period * (k % 3 == 0 ? 2.0 : 0.75);
      t += dt;
      v = filter.update(5.0 + 0.05 * t, dt);
    }
    QVERIFY(std::abs(v - 0.05) < 1e-9);
  }

  void a_window_of_one_is_the_difference() {
    AdaptiveWindow filter = foaw(AdaptiveWindow::Fit::best, 1);
    BackwardDifference difference;
    for (int k = 1; k < 200; ++k) {
      const double x = counted(0.01 * std::sin(0.05 * k));
      QCOMPARE(filter.update(x, period), difference.update(x, period));
    }
  }

  void starts_at_rest_wherever_it_is_data() {
    QTest::addColumn<QString>("type");
    QTest::newRow("Difference") << "Difference";
    QTest::newRow("Foaw") << "Foaw";
  }
  void starts_at_rest_wherever_it_is() {
    QFETCH(QString, type);
    GraphBench bench;
    const NodeId filter = bench.add(type.toStdString());
    const NodeId source = bench.feed({joints_in({"m", "rad"}),
                                      [](double t, auto v) {
                                        v[0] = 0.1 + 0.25 * t;
                                        v[1] = -2.0;
                                      },
                                      {.delay = 1e-3, .resolution = {count, 2 * count}}});
    bench.connect(source, "value", filter, "position");
    QCOMPARE(bench.wire(), std::string());
    bench.tick();
    QCOMPARE(bench.number(filter, "velocity", 0), 0.0);
    bench.tick(40);
    QVERIFY(std::abs(bench.number(filter, "velocity", 0) - 0.25) < 1e-9);
    QCOMPARE(bench.number(filter, "velocity", 1), 0.0);
    QCOMPARE(bench.output(filter, "velocity").signature()->text(),
             std::string("Joints of 2 axes [m/s, rad/s]"));
  }

  void quality_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<double>("late");  // [ms]
    QTest::addColumn<double>("step");  // [m/s] of one count
    QTest::newRow("the difference is fresh and coarse") << "Difference" << 1.5 << 1e-3;
    QTest::newRow("the window is late and fine") << "Foaw" << 8.5 << 1e-3 / 15;
  }
  void quality() {
    QFETCH(QString, type);
    QFETCH(double, late);
    QFETCH(double, step);
    GraphBench bench;
    const NodeId filter = bench.add(type.toStdString());
    const NodeId source =
        bench.feed({vector_in("m"), [](double, auto) {}, {1e-3, {count, 2 * count, 0.0}}});
    bench.connect(source, "value", filter, "position");
    QCOMPARE(bench.wire(), std::string());
    const SignalQuality& quality = bench.output(filter, "velocity").quality;
    QVERIFY(std::abs(1e3 * quality.delay - late) < 1e-9);
    QVERIFY(std::abs(quality.resolution.at(0) - step) < 1e-12);
    QVERIFY(std::abs(quality.resolution.at(1) - 2 * step) < 1e-12);
    QCOMPARE(quality.resolution.at(2), 0.0);
  }

  void the_band_is_for_signals_without_a_resolution_data() {
    QTest::addColumn<QString>("band");
    QTest::addColumn<QString>("says");
    QTest::newRow("in its unit") << "1 um"
                                 << "";
    QTest::newRow("in another unit") << "1 N"
                                     << "has that unit";
    QTest::newRow("negative") << "-1 um"
                              << "must be at least 0";
  }
  void the_band_is_for_signals_without_a_resolution() {
    QFETCH(QString, band);
    QFETCH(QString, says);
    GraphBench bench;
    const NodeId filter = bench.add("Foaw", {{"band", {band.toStdString()}}});
    const NodeId source =
        bench.feed({real_in("m"), [](double t, auto v) { v[0] = counted(3.3e-3 * t); }});
    bench.connect(source, "value", filter, "position");
    const std::string report = bench.wire();
    QCOMPARE(report.empty(), says.isEmpty());
    QVERIFY2(QString::fromStdString(report).contains(says), report.c_str());
    if (!says.isEmpty()) return;
    bench.tick(200);
    QVERIFY(std::abs(bench.number(filter, "velocity") - 3.3e-3) < 7e-5);
  }
};

QTEST_APPLESS_MAIN(TestVelocity)
#include "tst_velocity.moc"
