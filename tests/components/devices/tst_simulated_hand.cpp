// SPDX-License-Identifier: Apache-2.0
#include "components/devices/simulated_hand.hpp"

#include <Eigen/Geometry>
#include <QTest>
#include <limits>
#include <stdexcept>

#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using trocar::test::sixth_order_derivative;

namespace {

Tool::State tool_at(const PoseCoordinates& pose) {
  Tool::State s;
  [[maybe_unused]] const auto status = Tool(.15, .02, RollModel::gimbal_outer_y).inverse(pose, s);
  return s;
}

const Tool::State rest = tool_at({{0, 0, .085}, 0, 0, 0});

SimulatedHand grasping(const HandSettings& settings) {
  SimulatedHand hand(settings);
  hand.grasp(rest);
  return hand;
}

}  // namespace

class TestSimulatedHand : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void holding_it_pulls_back_to_where_it_grasped() {
    const SimulatedHand hand = grasping({.mode = HandMode::firm});
    QVERIFY(hand.spring_wrench(rest, 0.0).isZero(0.0));
    const Vector6d f = hand.spring_wrench(tool_at({{.004, 0, .085}, 0, 0, .1}), 5.0);
    QVERIFY((f - (Vector6d() << -1.0, 0, 0, 0, 0, -.1).finished()).norm() < 1e-12);
  }

  void relaxed_it_pulls_a_share_as_much() {
    const SimulatedHand hand = grasping({.mode = HandMode::relaxed, .relaxed_grip = 0.2});
    const Vector6d f = hand.spring_wrench(tool_at({{.004, 0, .085}, 0, 0, .1}), 5.0);
    QVERIFY((f - (Vector6d() << -.2, 0, 0, 0, 0, -.02).finished()).norm() < 1e-12);
    QCOMPARE(hand.settings().damping, 0.2 * 8.0);
    QCOMPARE(hand.settings().rotational_damping, 0.2 * 0.02);
    QCOMPARE(hand.settings().mass, 0.3);
    QCOMPARE(grasping({.relaxed_grip = 0.2}).settings().stiffness, 250.0);
  }

  void a_bowed_path_is_off_its_line_half_way_and_velocity_is_its_derivative() {
    HandSettings s{.mode = HandMode::pushes};
    s.push = {.bow = {.010, -.005, 0}, .depth = .04, .start = 0.0, .rise = 1.0};
    const SimulatedHand hand = grasping(s);
    const Vector3d half = hand.target(0.5) - rest.tip;
    QVERIFY((half - Vector3d(.010, -.005, .02)).norm() < 1e-15);
    QVERIFY((hand.target(1.2) - rest.tip - Vector3d(0, 0, .04)).norm() < 1e-15);
    for (const double t : {0.1, 0.5, 0.8, 2.3}) {
      const Vector3d slope = (hand.target(t + 1e-5) - hand.target(t - 1e-5)) / 2e-5;
      QVERIFY((hand.target_velocity(t) - slope).norm() < 1e-9);
    }
  }

  void absent_it_does_nothing() {
    const SimulatedHand hand = grasping({.mode = HandMode::absent});
    QVERIFY(!hand.present());
    QVERIFY(hand.spring_wrench(tool_at({{.01, 0, .09}, .1, 0, 0}), 1.0).isZero(0.0));
  }

  void push_follows_its_raised_cosine_data() {
    QTest::addColumn<double>("time");      // [s]
    QTest::addColumn<double>("expected");  // depth [m]
    QTest::newRow("before the start") << 0.4 << 0.0;
    QTest::newRow("a quarter of the rise") << 1.0 << 0.03 * (0.5 - std::sqrt(0.125));
    QTest::newRow("half of the rise") << 1.5 << 0.015;
    QTest::newRow("risen") << 2.5 << 0.03;
    QTest::newRow("dwelling") << 3.4 << 0.03;
    QTest::newRow("half way back") << 4.5 << 0.015;
    QTest::newRow("back, dwelling") << 6.0 << 0.0;
    QTest::newRow("half of the second rise") << 7.5 << 0.015;
  }
  void push_follows_its_raised_cosine() {
    QFETCH(double, time);
    QFETCH(double, expected);
    const SimulatedHand hand = grasping({.mode = HandMode::pushes,
                                         .push = {.direction = Vector3d::UnitX(),
                                                  .depth = .03,
                                                  .start = .5,
                                                  .rise = 2.0,
                                                  .dwell = 1.0}});
    QVERIFY((hand.target(time) - rest.tip - expected * Vector3d::UnitX()).norm() < 1e-15);
    const Vector3d rate =
        sixth_order_derivative([&](double s) { return hand.target(time + s); }, 1e-4);
    QVERIFY((hand.target_velocity(time) - rate).norm() < 1e-5);
  }

  void an_infinite_dwell_stays_pushed() {
    const SimulatedHand hand =
        grasping({.mode = HandMode::pushes,
                  .push = {.depth = .03, .dwell = std::numeric_limits<double>::infinity()}});
    QCOMPARE(hand.target(1e6), Vector3d(rest.tip + Vector3d(0, 0, .03)));
    QCOMPARE(hand.target_velocity(1e6), Vector3d(Vector3d::Zero()));
  }

  void spring_wrench_does_the_work_of_its_potential() {
    const SimulatedHand hand = grasping({.mode = HandMode::firm});
    const auto moved = [](double s) {
      return tool_at(
          {Vector3d(.01, -.02, .08) + s * Vector3d(1, 2, -1), .3 + s, -.2 - 3 * s, .4 + 5 * s});
    };
    const Vector3d tip = sixth_order_derivative([&](double s) { return moved(s).tip; }, 1e-3);
    const Matrix3d rate = sixth_order_derivative([&](double s) { return moved(s).rotation; }, 1e-3);
    const Matrix3d w = rate * moved(0).rotation.transpose();
    const Vector6d twist = (Vector6d() << tip, w(2, 1), w(0, 2), w(1, 0)).finished();
    const double slope =
        sixth_order_derivative([&](double s) { return hand.potential(moved(s), 0.0); }, 1e-3);
    QVERIFY(std::abs(hand.spring_wrench(moved(0), 0.0).dot(twist) + slope) < 1e-9);
  }

  void rotation_vector_is_axis_times_angle() {
    for (const double angle : {0.0, 1e-12, 1e-6, 0.5, 1.6, 3.1}) {
      const Vector3d axis = Vector3d(1, -2, .5).normalized();
      const Matrix3d r = Eigen::AngleAxisd(angle, axis).matrix();
      QVERIFY((rotation_vector(r) - angle * axis).norm() < 1e-13);
    }
  }

  void impossible_settings_are_refused_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<QString>("expected");
    QTest::newRow("mass") << 0 << "mass = -1: needs a value of at least 0";
    QTest::newRow("rise") << 1 << "push.rise = 0: needs a time above 0 s";
    QTest::newRow("direction") << 2 << "length of push.direction = 2: needs a unit vector";
    QTest::newRow("stiffness") << 3 << "stiffness = nan";
  }
  void impossible_settings_are_refused() {
    QFETCH(int, which);
    QFETCH(QString, expected);
    HandSettings s;
    if (which == 0) s.mass = -1.0;
    if (which == 1) s.push.rise = 0.0;
    if (which == 2) s.push.direction = {0, 2, 0};
    if (which == 3) s.stiffness = std::nan("");
    try {
      const SimulatedHand hand(s);
      QFAIL("accepted");
    } catch (const std::invalid_argument& error) {
      QVERIFY2(QString(error.what()).contains(expected), error.what());
    }
  }
};

QTEST_APPLESS_MAIN(TestSimulatedHand)
#include "tst_simulated_hand.moc"
