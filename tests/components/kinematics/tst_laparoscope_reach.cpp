// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_reach.hpp"

#include <QTest>
#include <cmath>
#include <numbers>

#include "components/kinematics/laparoscope_limits.hpp"
#include "components/kinematics/sobol.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

const LaparoscopeGeometry geometry;
const LaparoscopeLimits limits;

Eigen::Vector3d tip_of(const Sobol::Point& x, const LaparoscopeReach::Bounds& b) {
  const double radius = b.radius * std::sqrt(x[0]), angle = 2.0 * std::numbers::pi * x[1];
  return {radius * std::cos(angle), radius * std::sin(angle), std::lerp(b.low, b.high, x[2])};
}

/// The same question to a grid of slopes so dense that only a sliver escapes it.
bool grid_reaches(const LaparoscopeReach& reach, const LaparoscopeLimits& within,
                  const Eigen::Vector3d& tip) {
  constexpr int rings = 150;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < std::max(1, 4 * i); ++j) {
      const double slope = std::tan(within.tilt) * i / rings;
      const double angle = 2.0 * std::numbers::pi * j / std::max(1, 4 * i);
      if (reach.margin_at_rest(tip, {slope * std::cos(angle), slope * std::sin(angle)}) >= 0.0)
        return true;
    }
  return false;
}

}  // namespace

class TestLaparoscopeReach : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_margin_is_what_the_model_calls_reachable_data() {
    QTest::addColumn<double>("link_length");
    QTest::addColumn<double>("ring_plane");
    QTest::addColumn<double>("link_angle");  // [deg]
    QTest::newRow("default") << 0.210 << 0.020 << 60.0;
    QTest::newRow("short links") << 0.190 << 0.020 << 60.0;
    QTest::newRow("links that stay steep") << 0.210 << 0.020 << 42.0;
    QTest::newRow("a ring plane below the base") << 0.210 << -0.030 << 60.0;
  }
  void a_margin_is_what_the_model_calls_reachable() {
    QFETCH(double, link_length);
    QFETCH(double, ring_plane);
    QFETCH(double, link_angle);
    const LaparoscopeGeometry g{.ring_plane = ring_plane, .link_length = link_length};
    const LaparoscopeLimits l{.link_angle = link_angle * std::numbers::pi / 180.0};
    const LaparoscopeReach reach(g, l);
    const LaparoscopeModel model(g);
    Sobol points(5);
    int inside = 0;
    for (int i = 0; i < 60'000; ++i) {
      const Sobol::Point x = points.next();
      const Eigen::Vector3d tip = tip_of(x, reach.bounds());
      const Eigen::Vector2d slopes(2.2 * x[3] - 1.1, 2.2 * x[4] - 1.1);
      const bool fits =
          reachable(model, l, {tip, std::atan(slopes.x()), std::atan(slopes.y()), 0.0});
      inside += fits;
      QCOMPARE(reach.margin(tip, slopes) >= 0.0, fits);
    }
    QVERIFY(inside > 300);
  }

  void each_reachable_pose_has_a_reachable_tip() {
    const LaparoscopeReach reach(geometry, limits);
    for (const PoseCoordinates& pose : random_reachable_poses(2000))
      QVERIFY(reach.reaches(pose.tip));
  }

  void the_search_finds_what_a_dense_grid_finds() {
    const LaparoscopeReach reach(geometry, limits);
    Sobol points(99);
    int found = 0, missed = 0;
    for (int i = 0; i < 1024; ++i) {
      const Eigen::Vector3d tip = tip_of(points.next(), reach.bounds());
      const bool fits = reach.reaches(tip);
      found += fits;
      missed += !fits && grid_reaches(reach, limits, tip);
    }
    QVERIFY(found > 300);
    QVERIFY2(missed <= 1, qPrintable(QString::number(missed)));
  }

  void no_pose_is_outside_the_bounds() {
    const auto bounds = LaparoscopeReach(geometry, limits).bounds();
    for (const PoseCoordinates& pose : random_reachable_poses(2000)) {
      QVERIFY(pose.tip.head<2>().norm() <= bounds.radius);
      QVERIFY(pose.tip.z() >= bounds.low && pose.tip.z() <= bounds.high);
    }
  }

  void rings_that_turn_little_keep_the_centre_near_the_axis() {
    LaparoscopeLimits narrow = limits;
    narrow.ring_travel = 0.3;  // r sin(0.3) = 26.6 mm
    const LaparoscopeReach reach(geometry, narrow);
    QVERIFY(reach.margin_at_rest({0.0, 0.026, 0.085}, {0.0, 0.0}) > 0.0);
    QVERIFY(reach.margin_at_rest({0.0, 0.027, 0.085}, {0.0, 0.0}) < 0.0);
    QVERIFY(reach.margin({0.0, 0.027, 0.085}, {0.0, 0.0}) > 0.0);
  }

  void what_is_nowhere_is_not_reached_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("z");
    QTest::newRow("far to the side") << 0.3 << 0.085;
    QTest::newRow("beyond the tool") << 0.0 << 0.2;
    QTest::newRow("in the ring plane") << 0.0 << 0.020;
    QTest::newRow("behind the ring plane") << 0.0 << -0.1;
    QTest::newRow("not a number") << std::nan("") << 0.085;
    QTest::newRow("at no height") << 0.0 << std::nan("");
  }
  void what_is_nowhere_is_not_reached() {
    QFETCH(double, x);
    QFETCH(double, z);
    QVERIFY(!LaparoscopeReach(geometry, limits).reaches({x, 0.0, z}));
  }

  void what_cannot_be_is_refused() {
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument,
                             LaparoscopeReach({.base_radius = 0.01}, limits));
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, LaparoscopeReach(geometry, {.tilt = 1.6}));
  }

  void nothing_allocates() {
    const LaparoscopeReach reach(geometry, limits);
    int found = 0;
    const int n = allocations_in([&] {
      for (int i = 0; i < 100; ++i) found += reach.reaches({0.001 * i, 0.02, 0.1});
    });
    QCOMPARE(n, 0);
    QVERIFY(found > 0);
  }
};

QTEST_APPLESS_MAIN(TestLaparoscopeReach)
#include "tst_laparoscope_reach.moc"
