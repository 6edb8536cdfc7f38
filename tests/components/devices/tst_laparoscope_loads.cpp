// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope_loads.hpp"

#include <Eigen/Geometry>
#include <QTest>

#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;
using Eigen::Vector3d;

namespace {

const LaparoscopeModel model;

LaparoscopeConfiguration at(const PoseCoordinates& pose) {
  Vector6d q;
  LaparoscopeConfiguration c;
  if (model.inverse(pose, q) != AssemblyStatus::ok || model.forward(q, c) != AssemblyStatus::ok)
    qFatal("no such pose");
  return c;
}

Vector6d effort_of(const LaparoscopeConfiguration& c, const Vector3d& f, const Vector3d& m,
                   double s) {
  const Vector6d there = (Vector6d() << f, m).finished();
  return static_effort(model.rates(c), wrench_at_tip(c.tool, point_on_tool(c.tool, s), there));
}

}  // namespace

class TestLaparoscopeLoads : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_hand_feels_what_was_put_into_the_effort() {
    const Vector3d f(3, -5, 8), m(.1, -.2, .3);
    LaparoscopeLoads loads({}, -.15);
    for (const PoseCoordinates& pose : random_reachable_poses(50)) {
      const auto c = at(pose);
      QVERIFY(loads.update(c.q) == AssemblyStatus::ok);
      const auto on = loads.of(effort_of(c, f, m, -.15));
      QVERIFY((on.handle_force - f).norm() < 1e-11);
      QVERIFY((on.handle_moment - m).norm() < 1e-11);
    }
  }

  void the_stages_carry_the_force_by_the_lever_data() {
    QTest::addColumn<double>("tip_height");  // E upright on the axis [m]
    QTest::addColumn<double>("span");        // M [m]
    QTest::newRow("neutral") << .085 << .085;
    QTest::newRow("pushed in: the delta's end close to the gimbal") << .140 << .030;
  }
  void the_stages_carry_the_force_by_the_lever() {
    QFETCH(double, tip_height);
    QFETCH(double, span);
    const auto c = at({{0, 0, tip_height}, 0, 0, 0});
    LaparoscopeLoads loads({}, 0.0);
    QVERIFY(loads.update(c.q) == AssemblyStatus::ok);
    const auto on = loads.of(effort_of(c, {10, 0, 4}, Vector3d::Zero(), 0.0));
    const double lever = .150 / span;
    QVERIFY((on.gimbal - Vector3d(10 * lever, 0, 0)).norm() < 1e-10);
    QVERIFY((on.delta - Vector3d(-10 * (lever - 1.0), 0, 4)).norm() < 1e-10);
  }

  void the_stages_together_give_force_and_moment_of_a_tilted_tool() {
    const auto c = at({{.02, -.03, .09}, .3, -.2, .5});
    LaparoscopeLoads loads({}, 0.0);
    QVERIFY(loads.update(c.q) == AssemblyStatus::ok);
    const Vector3d f(3, -5, 8), m(.1, -.2, .3), t = c.tool.axis;
    const auto on = loads.of(effort_of(c, f, m, 0.0));
    QVERIFY((on.gimbal + on.delta - f).norm() < 1e-11);
    QVERIFY(std::abs(on.gimbal.dot(t)) < 1e-11);
    const Vector3d turning =
        (c.tool.gimbal - c.tool.tip).cross(on.gimbal) + (c.tool.ball - c.tool.tip).cross(on.delta);
    const Vector3d lateral = m - t * t.dot(m);  // the rest is roll
    QVERIFY((turning - lateral).norm() < 1e-11);
  }

  void the_handle_moves_as_its_point() {
    const auto c = at({{.02, -.03, .09}, .3, -.2, .5});
    LaparoscopeLoads loads({}, -.15);
    QVERIFY(loads.update(c.q) == AssemblyStatus::ok);
    const Vector6d v = (Vector6d() << .1, -.2, .3, 1, -2, .5).finished();
    const double ball = (model.rates(c).delta.jacobian * v.head<3>()).norm();
    QVERIFY(std::abs(loads.handle_speed(v) - ball) < 1e-12);
  }

  void what_cannot_be_assembled_leaves_it_where_it_was() {
    const auto c = at({{0, 0, .085}, 0, 0, 0});
    LaparoscopeLoads loads({}, 0.0);
    QVERIFY(loads.update(c.q) == AssemblyStatus::ok);
    const Vector6d effort = effort_of(c, {1, 2, 3}, Vector3d::Zero(), 0.0);
    QVERIFY(loads.update(c.q + Vector6d::Unit(0)) != AssemblyStatus::ok);
    QVERIFY((loads.of(effort).handle_force - Vector3d(1, 2, 3)).norm() < 1e-12);
  }
};

QTEST_APPLESS_MAIN(TestLaparoscopeLoads)
#include "tst_laparoscope_loads.moc"
