// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/laparoscope_dexterity.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <QTest>
#include <cmath>
#include <numbers>

#include "components/kinematics/laparoscope_gravity.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;

namespace {

const LaparoscopeModel model;
const LaparoscopeEfforts efforts;
constexpr double ring_radius = 0.090;

LaparoscopeConfiguration at(const PoseCoordinates& pose) {
  Vector6d q;
  LaparoscopeConfiguration c;
  if (model.inverse(pose, q) != AssemblyStatus::ok || model.forward(q, c) != AssemblyStatus::ok)
    throw std::runtime_error("not assembled");
  return c;
}

Dexterity dexterity_at(const LaparoscopeConfiguration& c) {
  return dexterity(model.rates(c), ring_radius, efforts.peak(), efforts.continuous());
}

}  // namespace

class TestLaparoscopeDexterity : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void condition_and_manipulability_are_those_of_the_singular_values() {
    for (const PoseCoordinates& pose : random_reachable_poses(100)) {
      const LaparoscopeConfiguration c = at(pose);
      Matrix6d scaled = model.rates(c).jacobian;
      scaled.bottomRows<3>() *= 0.1;
      scaled.rightCols<3>() /= ring_radius;
      const Vector6d values = Eigen::JacobiSVD<Matrix6d>(scaled).singularValues();
      const Dexterity d = dexterity_at(c);
      QVERIFY(std::abs(d.condition / (values[0] / values[5]) - 1.0) < 1e-9);
      QVERIFY(std::abs(d.manipulability / values.prod() - 1.0) < 1e-9);
    }
  }

  void no_direction_is_worse_than_the_worst() {
    for (const PoseCoordinates& pose : random_reachable_poses(20)) {
      const LaparoscopeConfiguration c = at(pose);
      const LaparoscopeRates rates = model.rates(c);
      const Dexterity d = dexterity_at(c);
      double worst = 1e9;
      for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 60; ++j) {
          const double height = (2.0 * i + 1.0) / 60.0 - 1.0;
          const double angle = 2.0 * std::numbers::pi * j / 60.0;
          const double across = std::sqrt(1.0 - height * height);
          const Eigen::Vector3d u(across * std::cos(angle), across * std::sin(angle), height);
          worst = std::min(worst, force_along(rates, u, efforts.peak()));
        }
      QVERIFY(worst >= d.peak_force * (1.0 - 1e-12));
      QVERIFY2(worst < d.peak_force * 1.01, qPrintable(QString::number(worst / d.peak_force)));
    }
  }

  // Section "Workspace" of docs/mathematics.md.
  void the_neutral_pose_has_the_known_forces_data() {
    QTest::addColumn<int>("axis");
    QTest::addColumn<double>("peak");
    QTest::addColumn<double>("continuous");
    QTest::newRow("x") << 0 << 131.0 << 29.0;
    QTest::newRow("y") << 1 << 113.0 << 25.0;
    QTest::newRow("z") << 2 << 588.0 << 168.0;
  }
  void the_neutral_pose_has_the_known_forces() {
    QFETCH(int, axis);
    QFETCH(double, peak);
    QFETCH(double, continuous);
    const LaparoscopeConfiguration c = at({{0.0, 0.0, 0.085}, 0.0, 0.0, 0.0});
    const LaparoscopeRates rates = model.rates(c);
    const LaparoscopeGravity weight({}, {});
    const Vector6d held = weight.effort(c, rates, standard_gravity).cwiseAbs();
    const auto force = [&](const Vector6d& all) {
      return force_along(rates, Eigen::Vector3d::Unit(axis), all - held);
    };
    QVERIFY(std::abs(force(efforts.peak()) - peak) < 0.6);
    QVERIFY(std::abs(force(efforts.continuous()) - continuous) < 0.6);
  }

  void without_effort_there_is_no_force() {
    const LaparoscopeRates rates = model.rates(at({{0.0, 0.0, 0.085}, 0.0, 0.0, 0.0}));
    QCOMPARE(dexterity(rates, ring_radius, Vector6d::Zero(), Vector6d::Zero()).peak_force, 0.0);
  }

  void efforts_that_cannot_be_are_refused() {
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, validate({.ring_peak = -1.0}));
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, validate({.slider_continuous = std::nan("")}));
    validate(LaparoscopeEfforts{});
  }
};

QTEST_APPLESS_MAIN(TestLaparoscopeDexterity)
#include "tst_laparoscope_dexterity.moc"
