// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/tool.hpp"

#include <Eigen/Geometry>
#include <QTest>
#include <numbers>

#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// A motion through steep and turned poses; s is the time [s].
struct Motion {
  Vector3d ball, ball_rate, ball_drift;
  Eigen::Vector2d centre, centre_rate;
  double theta0, theta_rate;

  Tool::State at(const Tool& tool, double s) const {
    Tool::State state;
    const double theta = theta0 + theta_rate * s;
    const auto status = tool.forward(ball + s * ball_rate, centre + s * centre_rate, theta,
                                     {std::cos(theta), std::sin(theta)}, state);
    Q_ASSERT(status == AssemblyStatus::ok);
    Q_UNUSED(status);
    return state;
  }
  Vector3d span_rate() const { return Vector3d(centre_rate.x(), centre_rate.y(), 0.0) - ball_rate; }
  Vector6d rates() const {
    return (Vector6d() << ball_rate.x(), ball_rate.y(), -ball_rate.z(), centre_rate, theta_rate)
        .finished();
  }
};

const Motion motions[] = {
    {{0, 0, -.065}, {.1, .2, .05}, {}, {0, 0}, {-.2, .1}, 0.0, 1.0},
    {{.03, -.02, -.03}, {.1, -.3, .2}, {}, {-.03, .02}, {.1, .1}, 2.0, -3.0},
    {{-.04, .05, -.05}, {-.2, .1, -.1}, {}, {.02, .03}, {.3, -.1}, -3.5, 2.0},
    {{.05, .05, -.02}, {.0, .1, .1}, {}, {-.01, .0}, {-.1, .2}, 1.0, 0.0},
};

Vector3d angular_velocity(const Matrix3d& rate, const Matrix3d& r) {
  const Matrix3d w = rate * r.transpose();
  return 0.5 * Vector3d(w(2, 1) - w(1, 2), w(0, 2) - w(2, 0), w(1, 0) - w(0, 1));
}

}  // namespace

Q_DECLARE_METATYPE(trocar::RollModel)

class TestTool : public QObject {
  Q_OBJECT

  static void roll_models() {
    QTest::addColumn<RollModel>("roll");
    QTest::newRow("gimbal, outer axis y") << RollModel::gimbal_outer_y;
    QTest::newRow("gimbal, outer axis x") << RollModel::gimbal_outer_x;
    QTest::newRow("zero torsion") << RollModel::zero_torsion;
  }

 private Q_SLOTS:
  void rotation_is_proper_and_upright_where_theta_says_data() { roll_models(); }
  void rotation_is_proper_and_upright_where_theta_says() {
    QFETCH(RollModel, roll);
    const Tool tool(.15, .02, roll);
    for (const Motion& m : motions) {
      const Tool::State s = m.at(tool, 0.0);
      QVERIFY((s.rotation.transpose() * s.rotation - Matrix3d::Identity()).norm() < 1e-14);
      QVERIFY(std::abs(s.rotation.determinant() - 1.0) < 1e-14);
      QVERIFY((s.rotation.col(2) - s.axis).norm() < 1e-15);
      QVERIFY(std::abs(std::remainder(ring_angle(roll, s.rotation) - s.theta,
                                      2 * std::numbers::pi)) < 1e-14);
    }
    const RingDirection ring(std::cos(0.7), std::sin(0.7));
    const Matrix3d upright = tool_rotation(roll, Vector3d::UnitZ(), ring);
    QVERIFY((upright - Eigen::AngleAxisd(0.7, Vector3d::UnitZ()).matrix()).norm() < 1e-15);
  }

  void rotation_is_the_product_of_its_joints() {
    using Eigen::AngleAxisd;
    const double th = 0.9, g1 = 0.4, g2 = -0.6;
    const Matrix3d rz = AngleAxisd(th, Vector3d::UnitZ()).matrix();
    const RingDirection ring(std::cos(th), std::sin(th));
    const Matrix3d y_then_x =
        rz * AngleAxisd(g1, Vector3d::UnitY()) * AngleAxisd(g2, Vector3d::UnitX());
    const Matrix3d x_then_y =
        rz * AngleAxisd(g1, Vector3d::UnitX()) * AngleAxisd(g2, Vector3d::UnitY());
    QVERIFY((tool_rotation(RollModel::gimbal_outer_y, y_then_x.col(2), ring) - y_then_x).norm() <
            1e-15);
    QVERIFY((tool_rotation(RollModel::gimbal_outer_x, x_then_y.col(2), ring) - x_then_y).norm() <
            1e-15);
    const Vector3d t = y_then_x.col(2);
    const Vector3d across = Vector3d::UnitZ().cross(t);
    const Matrix3d swing =
        AngleAxisd(std::atan2(across.norm(), t.z()), across.normalized()).matrix();
    QVERIFY((tool_rotation(RollModel::zero_torsion, t, ring) - swing * rz).norm() < 1e-15);
  }

  void models_differ_in_roll_by_what_is_known_data() {
    QTest::addColumn<double>("tilt");        // [deg]
    QTest::addColumn<double>("to_outer_x");  // [deg], largest over all directions
    QTest::addColumn<double>("to_zero_torsion");
    QTest::newRow("10 deg") << 10.0 << 0.9 << 0.4;
    QTest::newRow("20 deg") << 20.0 << 3.6 << 1.8;
    QTest::newRow("30 deg") << 30.0 << 8.2 << 4.1;
    QTest::newRow("45 deg") << 45.0 << 19.5 << 9.9;
  }
  void models_differ_in_roll_by_what_is_known() {
    QFETCH(double, tilt);
    QFETCH(double, to_outer_x);
    QFETCH(double, to_zero_torsion);
    double outer_x = 0.0, zero_torsion = 0.0;
    for (int k = 0; k < 720; ++k) {
      const double a = k * 0.5 * degree;
      const Vector3d t(std::sin(tilt * degree) * std::cos(a), std::sin(tilt * degree) * std::sin(a),
                       std::cos(tilt * degree));
      const RingDirection ring(1.0, 0.0);
      const Matrix3d y = tool_rotation(RollModel::gimbal_outer_y, t, ring);
      const auto angle_to = [&](RollModel m) {
        return Eigen::AngleAxisd(Matrix3d(y.transpose() * tool_rotation(m, t, ring))).angle() /
               degree;
      };
      outer_x = std::max(outer_x, angle_to(RollModel::gimbal_outer_x));
      zero_torsion = std::max(zero_torsion, angle_to(RollModel::zero_torsion));
    }
    QVERIFY2(std::abs(outer_x - to_outer_x) < 0.06, qPrintable(QString::number(outer_x)));
    QVERIFY2(std::abs(zero_torsion - to_zero_torsion) < 0.06,
             qPrintable(QString::number(zero_torsion)));
  }

  void jacobian_is_the_derivative_of_tip_and_rotation_data() { roll_models(); }
  void jacobian_is_the_derivative_of_tip_and_rotation() {
    QFETCH(RollModel, roll);
    const Tool tool(.15, .02, roll);
    for (const Motion& m : motions) {
      const Tool::State now = m.at(tool, 0.0);
      const Vector6d twist = tool.jacobian(now) * m.rates();
      const Vector3d tip =
          sixth_order_derivative([&](double s) { return Vector3d(m.at(tool, s).tip); }, 1e-3);
      const Matrix3d rate =
          sixth_order_derivative([&](double s) { return Matrix3d(m.at(tool, s).rotation); }, 1e-3);
      QVERIFY((twist.head<3>() - tip).norm() < 1e-9 * (1.0 + tip.norm()));
      const Vector3d omega = angular_velocity(rate, now.rotation);
      QVERIFY((twist.tail<3>() - omega).norm() < 1e-9 * (1.0 + omega.norm()));
    }
  }

  void pose_rate_jacobian_is_the_derivative_of_the_coordinates() {
    const Tool tool(.15, .02, RollModel::gimbal_outer_y);
    for (const Motion& m : motions) {
      const auto coordinates = [&](double s) {
        const PoseCoordinates p = m.at(tool, s).pose();
        return (Vector6d() << p.tip, p.alpha, p.beta, p.theta).finished();
      };
      const Vector6d expected = sixth_order_derivative(coordinates, 1e-3);
      const Vector6d rate = tool.pose_rate_jacobian(m.at(tool, 0.0)) * m.rates();
      QVERIFY((rate - expected).norm() < 1e-9 * expected.norm());
    }
  }

  void drift_is_the_second_derivative_data() { roll_models(); }
  void drift_is_the_second_derivative() {
    QFETCH(RollModel, roll);
    const Tool tool(.15, .02, roll);
    for (const Motion& m : motions) {
      const auto twist = [&](double s) {
        return Vector6d(tool.jacobian(m.at(tool, s)) * m.rates());
      };
      const Vector6d expected = sixth_order_derivative(twist, 1e-3);
      const Tool::Drift drift =
          tool.drift(m.at(tool, 0.0), m.span_rate(), m.theta_rate, Vector3d::Zero(), 0.0);
      QVERIFY((tool.length() * drift.axis - expected.head<3>()).norm() < 1e-8 * expected.norm());
      QVERIFY((drift.angular - expected.tail<3>()).norm() < 1e-8 * expected.norm());
    }
  }

  void inverse_is_regular_with_the_tip_in_the_ring_plane() {
    const Tool tool(.15, .02, RollModel::gimbal_outer_y);
    Tool::State s;
    QCOMPARE(tool.inverse({{.01, .02, .02}, .3, -.2, 1.0}, s), AssemblyStatus::ok);
    QVERIFY((s.gimbal - Vector3d(.01, .02, .02)).norm() < 1e-17);
    QVERIFY(std::abs(s.engagement - .15) < 1e-15);
  }

  void combined_tilt_exceeds_either_angle() {
    const Tool tool(.15, .02, RollModel::gimbal_outer_y);
    Tool::State s;
    QCOMPARE(tool.inverse({{0, 0, .1}, 40 * degree, 40 * degree, 0.0}, s), AssemblyStatus::ok);
    QVERIFY(std::abs(s.tilt() / degree - 49.9) < 0.05);
  }

  void refuses_what_has_no_pose_data() {
    QTest::addColumn<double>("alpha");
    QTest::addColumn<double>("theta");
    QTest::addColumn<QString>("reason");
    QTest::newRow("90 deg of tilt") << 90 * degree << 0.0 << "tool is tilted by 90 deg or more";
    QTest::newRow("-100 deg of tilt") << -100 * degree << 0.0 << "tool is tilted by 90 deg or more";
    QTest::newRow("an angle that is not a number")
        << std::nan("") << 0.0 << "tool is tilted by 90 deg or more";
    QTest::newRow("an infinite roll") << 0.0 << HUGE_VAL << "a coordinate is not a finite number";
  }
  void refuses_what_has_no_pose() {
    QFETCH(double, alpha);
    QFETCH(double, theta);
    QFETCH(QString, reason);
    const Tool tool(.15, .02, RollModel::gimbal_outer_y);
    Tool::State s;
    QCOMPARE(QString(describe(tool.inverse({{0, 0, .1}, alpha, 0.0, theta}, s))), reason);
  }

  void refuses_the_ball_joint_in_front_of_the_ring_plane() {
    const Tool tool(.15, .02, RollModel::gimbal_outer_y);
    Tool::State s;
    QCOMPARE(tool.forward({0, 0, .02}, {0, 0}, 0.0, {1, 0}, s),
             AssemblyStatus::tool_points_backwards);
  }

  void an_orientation_keeps_the_turn_that_is_near() {
    const Tool tool(.15, .02, RollModel::gimbal_outer_y);
    Tool::State s;
    QCOMPARE(tool.inverse({{0, 0, .1}, .2, -.3, 3.9}, s), AssemblyStatus::ok);
    const Matrix3d rotation = s.rotation;
    QCOMPARE(tool.inverse(s.tip, rotation, 3.5, s), AssemblyStatus::ok);
    QVERIFY(std::abs(s.theta - 3.9) < 1e-14);
    QCOMPARE(tool.inverse(s.tip, rotation, 0.0, s), AssemblyStatus::ok);
    QVERIFY(std::abs(s.theta - (3.9 - 2 * std::numbers::pi)) < 1e-14);
  }

  void hooke_joint_is_not_uniform_but_bounded() {
    const Tool tool(.15, .02, RollModel::gimbal_outer_y);
    Tool::State s;
    double slowest = 10.0, fastest = 0.0;
    for (int k = 0; k < 360; ++k) {
      QCOMPARE(tool.inverse({{0, 0, .1}, 45 * degree, 0.0, k * degree}, s), AssemblyStatus::ok);
      const double ratio = s.axis.dot(tool.rates(s).roll);
      slowest = std::min(slowest, ratio);
      fastest = std::max(fastest, ratio);
    }
    QVERIFY(std::abs(slowest - std::sqrt(0.5)) < 1e-12);
    QVERIFY(std::abs(fastest - std::sqrt(2.0)) < 1e-12);
  }

  void determinant_of_jr() {
    const Tool tool(.15, .02, RollModel::gimbal_outer_y);
    for (const Motion& m : motions) {
      const Tool::State s = m.at(tool, 0.0);
      const double u = Vector3d(-s.ring.y(), s.ring.x(), 0.0).dot(s.axis);
      const double expected =
          -s.axis.z() * s.axis.z() / (s.engagement * s.engagement * (1.0 - u * u));
      QVERIFY(std::abs(tool.jacobian(s).determinant() / expected - 1.0) < 1e-12);
    }
  }
};

QTEST_APPLESS_MAIN(TestTool)
#include "tst_tool.moc"
