// SPDX-License-Identifier: Apache-2.0
#include "components/devices/end_stops.hpp"

#include <QTest>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

const LaparoscopeModel model;
const EndStopSettings rubber;
const Vector6d still = Vector6d::Zero();

LaparoscopeConfiguration at(const Vector6d& q) {
  LaparoscopeConfiguration c;
  if (model.forward(q, c) != AssemblyStatus::ok) throw std::runtime_error("not assembled");
  return c;
}

EndStops::Reaction reaction(const LaparoscopeLimits& limits, const Vector6d& q,
                            const Vector6d& v = still) {
  const LaparoscopeConfiguration c = at(q);
  return EndStops(rubber, limits, model.geometry()).reaction(c, model.rates(c), v);
}

Vector6d place() {
  Vector6d q;
  if (model.inverse({{.02, -.01, .075}, .3, -.2, .5}, q) != AssemblyStatus::ok)
    throw std::runtime_error("not assembled");
  return q;
}

}  // namespace

Q_DECLARE_METATYPE(trocar::LaparoscopeLimits)

class TestEndStops : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void inside_all_limits_nothing_presses() {
    const auto r = reaction({}, place());
    QVERIFY(!r.any && r.effort.isZero(0.0) && r.damping.isZero(0.0));
  }

  void a_stop_pushes_down_its_potential_data() {
    QTest::addColumn<LaparoscopeLimits>("limits");
    QTest::addColumn<double>("potential");  // [J], 0: not compared
    const LaparoscopeConfiguration c = at(place());
    const auto spring = [](double k, double p) { return 0.5 * k * p * p; };
    const double k = rubber.stiffness, ka = rubber.angular_stiffness;
    QTest::newRow("slider above its end")
        << LaparoscopeLimits{.slider_high = c.q.head<3>().maxCoeff() - .001} << spring(k, .001);
    QTest::newRow("slider below its end")
        << LaparoscopeLimits{.slider_low = c.q.head<3>().minCoeff() + .001} << spring(k, .001);
    QTest::newRow("rings turned too far") << LaparoscopeLimits{.ring_travel = .4} << 0.0;
    QTest::newRow("star too far out")
        << LaparoscopeLimits{.centre_offset = c.rings.centre.norm() - .002} << spring(k, .002);
    QTest::newRow("tool pushed too far in")
        << LaparoscopeLimits{.engagement_low = c.tool.engagement + .001} << spring(k, .001);
    QTest::newRow("tool pulled too far out")
        << LaparoscopeLimits{.engagement_high = c.tool.engagement - .001} << spring(k, .001);
    QTest::newRow("tool too steep")
        << LaparoscopeLimits{.tilt = c.tool.tilt() - .01} << spring(ka, .01);
    QTest::newRow("links too flat")
        << LaparoscopeLimits{.link_angle =
                                 std::acos((c.delta.links.col(2).minCoeff() + .001) / .210)}
        << spring(k, .001);
  }
  void a_stop_pushes_down_its_potential() {
    QFETCH(LaparoscopeLimits, limits);
    QFETCH(double, potential);
    const auto r = reaction(limits, place());
    QVERIFY(r.any && r.potential > 0.0);
    if (potential > 0.0) QVERIFY(std::abs(r.potential / potential - 1.0) < 1e-9);
    for (int i = 0; i < 6; ++i) {
      const double slope = sixth_order_derivative(
          [&](double s) { return reaction(limits, place() + s * Vector6d::Unit(i)).potential; },
          1e-5);
      QVERIFY2(std::abs(r.effort[i] + slope) < 1e-6 * (1.0 + r.effort.norm()),
               qPrintable(QString("%1: %2, %3").arg(i).arg(r.effort[i]).arg(-slope)));
    }
  }

  void a_stop_brakes_what_enters_and_never_pulls_what_leaves() {
    const LaparoscopeLimits limits{.slider_high = place().head<3>().maxCoeff() - .001};
    const Vector6d speed = (Vector6d() << 1, 1, 1, 0, 0, 0).finished();
    const auto entering = reaction(limits, place(), speed);
    QVERIFY(std::abs(entering.damping.trace() - rubber.damping) < 1e-12);
    const auto leaving = reaction(limits, place(), -speed);  // 100 N of spring, 150 N of damper
    QVERIFY(leaving.effort.isZero(0.0) && leaving.damping.isZero(0.0));
    const auto slowly = reaction(limits, place(), -0.1 * speed);
    QVERIFY(std::abs(slowly.effort.minCoeff() + 100.0) < 1e-6);
  }

  void settings_that_do_not_fit_are_refused() {
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument,
                             EndStops(rubber, {.centre_offset = .2}, model.geometry()));
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument,
                             EndStops({.damping = -1.0}, LaparoscopeLimits{}, model.geometry()));
  }

  void it_does_not_allocate() {
    const LaparoscopeConfiguration c = at(place());
    const LaparoscopeRates rates = model.rates(c);
    const EndStops stops(rubber, {.ring_travel = .4, .tilt = .1}, model.geometry());
    double sum = 0.0;
    QCOMPARE(allocations_in([&] { sum += stops.reaction(c, rates, still).potential; }), 0);
    QVERIFY(sum > 0.0);
  }
};

QTEST_APPLESS_MAIN(TestEndStops)
#include "tst_end_stops.moc"
