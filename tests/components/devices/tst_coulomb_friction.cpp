// SPDX-License-Identifier: Apache-2.0
#include "components/devices/coulomb_friction.hpp"

#include <QTest>

#include "components/devices/seeded_random.hpp"
#include "tests/support/allocation_counter.hpp"

using namespace trocar;
using trocar::test::allocations_in;

namespace {

struct Problem {
  Matrix6d A;
  Vector6d b, limit, guess;
};

Problem random_problem(SeededRandom& random) {
  const auto draw = [&](auto& m) {
    for (int i = 0; i < m.size(); ++i) m.data()[i] = random.uniform(-1.0, 1.0);
  };
  Problem p;
  Matrix6d root;
  draw(root);
  p.A = root * root.transpose() + 0.1 * Matrix6d::Identity();
  draw(p.b);
  draw(p.limit);
  draw(p.guess);
  p.limit = p.limit.cwiseAbs();
  return p;
}

}  // namespace

class TestCoulombFriction : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void solution_obeys_coulomb_in_every_axis() {
    SeededRandom random(5);
    int most = 0, stuck = 0, sliding = 0;
    for (int k = 0; k < 20000; ++k) {
      const Problem p = random_problem(random);
      Vector6d v = p.guess;
      most = std::max(most, velocity_with_friction(p.A, p.b, p.limit, v));
      const Vector6d friction = p.b - p.A * v;
      for (int i = 0; i < 6; ++i) {
        (v[i] == 0.0 ? stuck : sliding)++;
        QVERIFY(std::abs(friction[i]) <= p.limit[i] + 1e-12);
        if (v[i] != 0.0) QVERIFY(std::abs(friction[i] - std::copysign(p.limit[i], v[i])) < 1e-11);
      }
    }
    QVERIFY2(most < friction_sweeps, qPrintable(QString::number(most)));
    QVERIFY(stuck > 10000 && sliding > 10000);
  }

  void without_friction_it_is_the_plain_solution_from_any_guess() {
    SeededRandom random(6);
    const Problem p = random_problem(random);
    Vector6d v = Vector6d::Zero();
    QCOMPARE(velocity_with_friction(p.A, p.b, Vector6d::Zero(), v), 0);
    QVERIFY((p.A * v - p.b).norm() < 1e-13);
  }

  void below_the_limit_everything_stops_exactly() {
    Vector6d v = Vector6d::Constant(0.3);
    QCOMPARE(velocity_with_friction(Matrix6d::Identity(), Vector6d::Constant(-0.5),
                                    Vector6d::Constant(0.5), v),
             0);
    QVERIFY(v.isZero(0.0));
  }

  void one_axis_slides_while_its_neighbour_sticks() {
    Matrix6d A = Matrix6d::Identity();
    A(0, 1) = A(1, 0) = 0.5;
    Vector6d v = Vector6d::Zero();
    velocity_with_friction(A, 2.0 * Vector6d::Unit(0), Vector6d::Ones(), v);
    QCOMPARE(v, Vector6d(Vector6d::Unit(0)));
  }

  void it_does_not_allocate() {
    SeededRandom random(7);
    const Problem p = random_problem(random);
    Vector6d v = p.guess;
    QCOMPARE(allocations_in([&] { velocity_with_friction(p.A, p.b, p.limit, v); }), 0);
  }
};

QTEST_APPLESS_MAIN(TestCoulombFriction)
#include "tst_coulomb_friction.moc"
