// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_model.hpp"

#include <Eigen/Geometry>
#include <QTest>

#include "components/kinematics/laparoscope_gravity.hpp"
#include "components/kinematics/laparoscope_limits.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

const LaparoscopeModel model;
const PoseCoordinates neutral{{0, 0, .085}, 0, 0, 0};

LaparoscopeConfiguration at(const LaparoscopeModel& m, const Vector6d& q) {
  LaparoscopeConfiguration c;
  [[maybe_unused]] const auto status = m.forward(q, c);
  return c;
}

Vector6d actuators(const LaparoscopeModel& m, const PoseCoordinates& pose) {
  Vector6d q;
  const auto status = m.inverse(pose, q);
  return status == AssemblyStatus::ok ? q : Vector6d::Constant(std::nan(""));
}

}  // namespace

class TestLaparoscopeModel : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void forward_undoes_inverse_on_10000_reachable_poses() {
    double tip = 0.0, angle = 0.0;
    for (const PoseCoordinates& p : random_reachable_poses(10000)) {
      const PoseCoordinates back = at(model, actuators(model, p)).tool.pose();
      tip = std::max(tip, (back.tip - p.tip).cwiseAbs().maxCoeff());
      angle = std::max({angle, std::abs(back.alpha - p.alpha), std::abs(back.beta - p.beta),
                        std::abs(back.theta - p.theta)});
    }
    QVERIFY2(tip <= 1e-12, qPrintable(QString::number(tip)));
    QVERIFY2(angle <= 1e-12, qPrintable(QString::number(angle)));
  }

  void jacobian_is_the_derivative_for_every_roll_model() {
    for (const RollModel roll :
         {RollModel::gimbal_outer_y, RollModel::gimbal_outer_x, RollModel::zero_torsion}) {
      const LaparoscopeModel m({.roll = roll});
      for (const PoseCoordinates& p : random_reachable_poses(20)) {
        const Vector6d q = actuators(m, p);
        Matrix6d expected;
        for (int i = 0; i < 6; ++i) {
          const double h = i < 3 ? 4e-4 : 6e-3;
          const auto moved = [&](double s) { return at(m, q + s * Vector6d::Unit(i)).tool; };
          expected.col(i).head<3>() =
              sixth_order_derivative([&](double s) { return Vector3d(moved(s).tip); }, h);
          const Matrix3d rate =
              sixth_order_derivative([&](double s) { return Matrix3d(moved(s).rotation); }, h);
          const Matrix3d w = rate * moved(0.0).rotation.transpose();
          expected.col(i).tail<3>() << w(2, 1), w(0, 2), w(1, 0);
        }
        QVERIFY(relative_error(model_jacobian(m, q), expected) < 2e-8);
      }
    }
  }

  void neutral_jacobian_has_the_known_figures() {
    Matrix6d expected;
    expected << .9414, -.4707, -.4707, 0, -.0917, .0917,  //
        0, .8153, -.8153, .1059, -.0529, -.0529,          //
        1 / 3., 1 / 3., 1 / 3., 0, 0, 0,                  //
        0, -12.543, 12.543, -.7059, .3529, .3529,         //
        14.483, -7.242, -7.242, 0, -.6113, .6113,         //
        0, 0, 0, 1 / 3., 1 / 3., 1 / 3.;
    const Matrix6d j = model_jacobian(model, actuators(model, neutral));
    QVERIFY((j - expected).cwiseAbs().maxCoeff() < 6e-4);
  }

  void equal_motion_of_both_ends_does_not_turn_the_tool() {
    const LaparoscopeConfiguration c = at(model, actuators(model, neutral));
    const LaparoscopeRates r = model.rates(c);
    Vector6d v;
    v << r.delta.jacobian.inverse() * Vector3d(.1, 0, 0), r.rings.inverse() * Vector3d(.1, 0, 0);
    const Vector6d twist = r.jacobian * v;
    QVERIFY((twist - Vector6d(.1 * Vector6d::Unit(0))).norm() < 1e-14);
  }

  void power_at_the_actuators_is_power_at_the_hand() {
    const Vector6d v = (Vector6d() << .1, -.2, .3, 1.0, -2.0, .5).finished();
    const Vector6d f = (Vector6d() << 3, -5, 8, .1, -.2, .3).finished();
    for (const PoseCoordinates& p : random_reachable_poses(100)) {
      const LaparoscopeRates r = model.rates(at(model, actuators(model, p)));
      const double actuators_give = static_effort(r, f).dot(v), hand_takes = f.dot(r.jacobian * v);
      QVERIFY(std::abs(actuators_give - hand_takes) < 1e-13 * (1.0 + std::abs(hand_takes)) * 10);
    }
  }

  void a_wrench_moved_to_the_tip_keeps_its_power() {
    const auto c = at(model, actuators(model, {{.02, -.03, .09}, .3, -.2, .5}));
    const Vector6d twist = (Vector6d() << .1, .2, -.3, 1, 2, -1).finished();
    const Vector6d f = (Vector6d() << 3, -5, 8, .1, -.2, .3).finished();
    const Vector3d x = point_on_tool(c.tool, -.06);
    QVERIFY((x - (c.tool.tip - .06 * c.tool.axis)).norm() < 1e-17);
    Vector6d twist_x = twist;
    twist_x.head<3>() = velocity_at(c.tool, x, twist);
    QVERIFY(std::abs(wrench_at_tip(c.tool, x, f).dot(twist) - f.dot(twist_x)) < 1e-14);
    QVERIFY((wrench_at_tip(c.tool, x, f) - f).norm() > 0.1);
  }

  void gravity_is_the_gradient_of_the_potential_under_any_mount() {
    const LaparoscopeGravity weight({}, {});
    for (const Vector3d& g : {standard_gravity, Vector3d(3, -9, 2), Vector3d(-9.81, 0, 0)}) {
      for (const PoseCoordinates& p : random_reachable_poses(20)) {
        const Vector6d q = actuators(model, p);
        const auto c = at(model, q);
        const Vector6d tau = weight.effort(c, model.rates(c), g);
        for (int i = 0; i < 6; ++i) {
          const double slope = sixth_order_derivative(
              [&](double s) { return weight.potential(at(model, q + s * Vector6d::Unit(i)), g); },
              i < 3 ? 4e-4 : 6e-3);
          QVERIFY(std::abs(slope - tau[i]) < 1e-9);
        }
      }
    }
  }

  void nothing_in_the_loop_allocates() {
    const LaparoscopeGravity weight({}, {});
    const Vector6d q = actuators(model, {{.02, -.03, .09}, .3, -.2, .5});
    Vector6d sum = Vector6d::Zero(), back;
    const int n = allocations_in([&] {
      for (int i = 0; i < 100; ++i) {
        LaparoscopeConfiguration c;
        if (model.forward(q, c) != AssemblyStatus::ok) continue;
        const LaparoscopeRates r = model.rates(c);
        sum += static_effort(r, wrench_at_tip(c.tool, point_on_tool(c.tool, -.1), q));
        sum += weight.effort(c, r, standard_gravity);
        sum[0] += weight.potential(c, standard_gravity);
        sum += model.tool().jacobian(c.tool) * q + model.tool().pose_rate_jacobian(c.tool) * q;
        if (model.inverse(c.tool.pose(), back) == AssemblyStatus::ok) sum += back;
        if (model.inverse(c.tool.tip, c.tool.rotation, 0.0, back) == AssemblyStatus::ok)
          sum += back;
        sum[1] += violated_limits({}, c).bits();
      }
    });
    QCOMPARE(n, 0);
    QVERIFY(sum.allFinite() && sum.norm() > 0.0);
  }

  void cost_of_forward_kinematics_and_jacobian() {
    const Vector6d q = actuators(model, {{.02, -.03, .09}, .3, -.2, .5});
    [[maybe_unused]] volatile double sink = 0.0;
    QBENCHMARK {
      LaparoscopeConfiguration c;
      if (model.forward(q, c) == AssemblyStatus::ok) sink = model.rates(c).jacobian(2, 3);
    }
  }

 private:
  static Matrix6d model_jacobian(const LaparoscopeModel& m, const Vector6d& q) {
    return m.rates(at(m, q)).jacobian;
  }
};

QTEST_APPLESS_MAIN(TestLaparoscopeModel)
#include "tst_laparoscope_model.moc"
