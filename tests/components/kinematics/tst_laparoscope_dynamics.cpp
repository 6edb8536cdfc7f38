// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_dynamics.hpp"

#include <Eigen/Cholesky>
#include <QTest>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;
using Eigen::Vector3d;

namespace {

const Vector6d velocity = (Vector6d() << .3, -.2, .4, 2.0, -1.5, 1.0).finished();

struct Point {
  LaparoscopeConfiguration configuration;
  LaparoscopeRates rates;
  LaparoscopeDynamics::Inertia inertia;
};

Point at(const LaparoscopeDynamics& d, const Vector6d& q) {
  Point p;
  [[maybe_unused]] const auto status = d.model().forward(q, p.configuration);
  p.rates = d.model().rates(p.configuration);
  p.inertia = d.inertia(p.configuration, p.rates);
  return p;
}

std::vector<Vector6d> places(const LaparoscopeDynamics& d) {
  std::vector<Vector6d> list;
  for (const PoseCoordinates& pose : random_reachable_poses(40)) {
    Vector6d q;
    if (d.model().inverse(pose, q) == AssemblyStatus::ok) list.push_back(q);
  }
  return list;
}

}  // namespace

Q_DECLARE_METATYPE(trocar::RollModel)

class TestLaparoscopeDynamics : public QObject {
  Q_OBJECT

  static void roll_models() {
    QTest::addColumn<RollModel>("roll");
    QTest::newRow("gimbal, outer axis y") << RollModel::gimbal_outer_y;
    QTest::newRow("gimbal, outer axis x") << RollModel::gimbal_outer_x;
    QTest::newRow("zero torsion") << RollModel::zero_torsion;
  }

 private Q_SLOTS:
  void mass_is_symmetric_and_positive() {
    const LaparoscopeDynamics d({}, {});
    for (const Vector6d& q : places(d)) {
      const Matrix6d m = at(d, q).inertia.mass;
      QVERIFY((m - m.transpose()).cwiseAbs().maxCoeff() < 1e-15);
      QVERIFY(m.llt().info() == Eigen::Success);
    }
  }

  // Lagrange: c = M' v - 1/2 d(v^T M v)/dq.
  void bias_follows_from_the_kinetic_energy_data() { roll_models(); }
  void bias_follows_from_the_kinetic_energy() {
    QFETCH(RollModel, roll);
    const LaparoscopeDynamics d({.roll = roll}, {});
    for (const Vector6d& q : places(d)) {
      const auto momentum = [&](double s) {
        return Vector6d(at(d, q + s * velocity).inertia.mass * velocity);
      };
      Vector6d expected = sixth_order_derivative(momentum, 1e-3);
      for (int i = 0; i < 6; ++i) {
        const auto energy = [&](double s) {
          const Vector6d moved = q + s * Vector6d::Unit(i);
          return 0.5 * velocity.dot(at(d, moved).inertia.mass * velocity);
        };
        expected[i] -= sixth_order_derivative(energy, i < 3 ? 4e-4 : 6e-3);
      }
      const Point p = at(d, q);
      const auto bias = d.bias(p.configuration, p.rates, p.inertia, velocity);
      QVERIFY2(relative_error(bias.effort, expected) < 1e-6,
               qPrintable(QString::number(relative_error(bias.effort, expected))));
    }
  }

  void accelerations_are_derivatives_of_the_twist_data() { roll_models(); }
  void accelerations_are_derivatives_of_the_twist() {
    QFETCH(RollModel, roll);
    const LaparoscopeDynamics d({.roll = roll}, {});
    for (const Vector6d& q : places(d)) {
      const auto twist = [&](double s) {
        return Vector6d(at(d, q + s * velocity).rates.jacobian * velocity);
      };
      const Vector6d expected = sixth_order_derivative(twist, 5e-4);
      const Point p = at(d, q);
      const auto bias = d.bias(p.configuration, p.rates, p.inertia, velocity);
      QVERIFY((bias.twist - twist(0.0)).norm() < 1e-13 * twist(0.0).norm());
      QVERIFY((bias.tip - expected.head<3>()).norm() < 1e-7 * expected.norm());
      QVERIFY((bias.angular - expected.tail<3>()).norm() < 1e-7 * expected.norm());
    }
  }

  void at_rest_there_is_no_bias() {
    const LaparoscopeDynamics d({}, {});
    const Point p = at(d, places(d).front());
    const auto bias = d.bias(p.configuration, p.rates, p.inertia, Vector6d::Zero());
    QVERIFY(bias.effort.isZero(0.0));
  }

  void lateral_tip_inertia_at_neutral_has_the_known_figures() {
    const LaparoscopeDynamics d({}, {});
    Vector6d q;
    QCOMPARE(d.model().inverse({{0, 0, .085}, 0, 0, 0}, q), AssemblyStatus::ok);
    const Point p = at(d, q);
    const Matrix6d mobility =
        p.rates.jacobian * p.inertia.mass.llt().solve(p.rates.jacobian.transpose());
    QVERIFY(std::abs(1.0 / mobility(0, 0) - 0.246) < 1e-3);
    QVERIFY(std::abs(1.0 / mobility(1, 1) - 0.246) < 1e-3);
    QVERIFY(std::abs(1.0 / mobility(2, 2) - 1.21) < 5e-3);
  }

  void nothing_allocates() {
    const LaparoscopeDynamics d({}, {});
    const Vector6d q = places(d).front();
    double sum = 0.0;
    const int n = allocations_in([&] {
      for (int i = 0; i < 100; ++i) {
        const Point p = at(d, q);
        sum +=
            p.inertia.mass(0, 0) + d.bias(p.configuration, p.rates, p.inertia, velocity).effort[0];
      }
    });
    QCOMPARE(n, 0);
    QVERIFY(sum != 0.0);
  }

  void cost() {
    const LaparoscopeDynamics d({}, {});
    const Vector6d q = places(d).front();
    [[maybe_unused]] volatile double sink = 0.0;
    QBENCHMARK {
      const Point p = at(d, q);
      sink = p.inertia.mass(0, 0) + d.bias(p.configuration, p.rates, p.inertia, velocity).effort[0];
    }
  }
};

QTEST_APPLESS_MAIN(TestLaparoscopeDynamics)
#include "tst_laparoscope_dynamics.moc"
