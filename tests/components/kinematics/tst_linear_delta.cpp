// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/linear_delta.hpp"

#include <QTest>

#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

const LinearDelta delta(.140, .040, .210);
const Vector3d places[] = {{0, 0, -.065}, {.05, -.03, -.05}, {-.04, -.06, -.09}, {.02, .07, -.03}};

Vector3d platform_at(const Vector3d& sliders) {
  LinearDelta::State s;
  [[maybe_unused]] const auto status = delta.forward(sliders, s);
  return s.platform;
}

}  // namespace

class TestLinearDelta : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void forward_undoes_inverse() {
    for (const Vector3d& a : places) {
      Vector3d q;
      QCOMPARE(delta.inverse(a, q), AssemblyStatus::ok);
      QVERIFY((platform_at(q) - a).norm() < 1e-15);
    }
  }

  void links_keep_their_length() {
    LinearDelta::State s;
    QCOMPARE(delta.forward({-.2, -.25, -.3}, s), AssemblyStatus::ok);
    for (int i = 0; i < 3; ++i) QVERIFY(std::abs(s.links.row(i).norm() - .210) < 1e-15);
  }

  void jacobian_and_drift_are_derivatives() {
    const Vector3d v(.3, -.2, .5);
    for (const Vector3d& a : places) {
      Vector3d q;
      QCOMPARE(delta.inverse(a, q), AssemblyStatus::ok);
      const auto velocity_at = [&](double s) {
        LinearDelta::State state;
        [[maybe_unused]] const auto status = delta.forward(q + s * v, state);
        return Vector3d(delta.rates(state).jacobian * v);
      };
      const Vector3d velocity =
          sixth_order_derivative([&](double s) { return platform_at(q + s * v); }, 4e-4);
      QVERIFY((velocity_at(0.0) - velocity).norm() < 1e-9 * velocity.norm());
      const Vector3d expected = sixth_order_derivative(velocity_at, 4e-4);
      LinearDelta::State state;
      QCOMPARE(delta.forward(q, state), AssemblyStatus::ok);
      const Vector3d drift = delta.drift(delta.rates(state), v, velocity_at(0.0));
      QVERIFY((drift - expected).norm() < 1e-9 * expected.norm());
    }
  }

  void pure_insertion_moves_the_platform_with_the_sliders() {
    LinearDelta::State s;
    QCOMPARE(delta.forward({-.25, -.25, -.25}, s), AssemblyStatus::ok);
    QVERIFY((delta.rates(s).jacobian * Vector3d::Ones() - Vector3d::UnitZ()).norm() < 1e-15);
    QVERIFY(std::abs(s.platform.z() - (-.25 + std::sqrt(.21 * .21 - .01))) < 1e-15);
  }

  void refuses_what_cannot_be_assembled_data() {
    QTest::addColumn<double>("q1");
    QTest::addColumn<double>("q2");
    QTest::addColumn<QString>("reason");
    QTest::newRow("sliders too far apart") << 0.2 << -0.3 << "delta links cannot reach";
    QTest::newRow("platform behind a slider")
        << -0.02 << -0.25 << "delta platform is not in front of all sliders";
    QTest::newRow("not a number") << std::nan("") << -0.25 << "a coordinate is not a finite number";
  }
  void refuses_what_cannot_be_assembled() {
    QFETCH(double, q1);
    QFETCH(double, q2);
    QFETCH(QString, reason);
    LinearDelta::State s;
    QCOMPARE(QString(describe(delta.forward({q1, q2, -.25}, s))), reason);
  }

  void refuses_a_platform_out_of_reach() {
    Vector3d q;
    QCOMPARE(delta.inverse({.2, 0, 0}, q), AssemblyStatus::delta_links_cannot_reach);
    QCOMPARE(delta.inverse({std::nan(""), 0, 0}, q), AssemblyStatus::not_finite);
  }
};

QTEST_APPLESS_MAIN(TestLinearDelta)
#include "tst_linear_delta.moc"
