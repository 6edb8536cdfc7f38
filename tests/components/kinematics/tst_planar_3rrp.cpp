// SPDX-License-Identifier: Apache-2.0
#include "components/kinematics/planar_3rrp.hpp"

#include <Eigen/LU>
#include <QTest>
#include <numbers>

#include "components/kinematics/three_phases.hpp"
#include "tests/support/laparoscope_poses.hpp"

using namespace trocar;
using namespace trocar::test;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double pi = std::numbers::pi;
const Planar3Rrp rings(.090);

struct Place {
  Vector2d centre;
  double theta;
};
const Place places[] = {{{0, 0}, 0.0},        {{.03, -.02}, 1.0},     {{-.05, .03}, -3.5},
                        {{0, .0599}, 3.1416}, {{.01, .08}, 4.0 * pi}, {{.0899, 0}, -0.3}};

Planar3Rrp::State assembled(const Vector3d& phi) {
  Planar3Rrp::State s;
  [[maybe_unused]] const auto status = rings.forward(phi, s);
  return s;
}

}  // namespace

class TestPlanar3Rrp : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void forward_undoes_inverse_over_any_number_of_turns() {
    for (const Place& p : places) {
      Vector3d phi;
      QCOMPARE(rings.inverse(p.centre, p.theta, phi), AssemblyStatus::ok);
      Planar3Rrp::State s;
      QCOMPARE(rings.forward(phi, s), AssemblyStatus::ok);
      QVERIFY((s.centre - p.centre).norm() < 1e-14);
      QVERIFY(std::abs(s.theta - p.theta) < 2e-14);
    }
  }

  void pins_lie_on_their_spokes() {
    for (const Place& p : places) {
      Vector3d phi;
      QCOMPARE(rings.inverse(p.centre, p.theta, phi), AssemblyStatus::ok);
      const Planar3Rrp::State s = assembled(phi);
      for (int i = 0; i < 3; ++i) {
        const Vector2d pin = .090 * Vector2d(std::cos(phi[i]), std::sin(phi[i]));
        QVERIFY((s.pins.col(i) - pin).norm() < 1e-15);
        QVERIFY((s.centre + s.rho[i] * s.along.col(i) - pin).norm() < 1e-14);
        QVERIFY(s.rho[i] > 0.0);
      }
    }
  }

  void jacobian_and_drift_are_derivatives() {
    const Vector3d v(2.0, -1.0, 1.5);
    for (const Place& p : places) {
      if (p.centre.norm() > 0.085) continue;  // differences would step over the edge
      Vector3d phi;
      QCOMPARE(rings.inverse(p.centre, p.theta, phi), AssemblyStatus::ok);
      const auto star_at = [&](double s) {
        const Planar3Rrp::State state = assembled(phi + s * v);
        return Vector3d(state.centre.x(), state.centre.y(), state.theta);
      };
      const auto rate_at = [&](double s) {
        return Vector3d(rings.jacobian(assembled(phi + s * v)) * v);
      };
      const Vector3d rate = sixth_order_derivative(star_at, 2e-3);
      QVERIFY((rate_at(0.0) - rate).norm() < 1e-9 * rate.norm());
      const Vector3d expected = sixth_order_derivative(rate_at, 2e-3);
      const Vector3d drift = rings.drift(assembled(phi), v, rate_at(0.0));
      QVERIFY((drift - expected).norm() < 1e-8 * (1.0 + expected.norm()));
    }
  }

  void determinant_of_jt() {
    for (const Place& p : places) {
      Vector3d phi;
      QCOMPARE(rings.inverse(p.centre, p.theta, phi), AssemblyStatus::ok);
      const Planar3Rrp::State s = assembled(phi);
      const double expected = (.090 * s.cos_eps).prod() / (std::numbers::sqrt3 / 2.0 * s.rho.sum());
      QVERIFY(std::abs(rings.jacobian(s).determinant() / expected - 1.0) < 1e-12);
    }
  }

  void rings_that_turn_together_roll_and_do_nothing_else() {
    const Planar3Rrp::State s = assembled({0.3, phase_angle[1] + 0.3, phase_angle[2] + 0.3});
    QVERIFY((rings.jacobian(s) * Vector3d::Ones() - Vector3d::UnitZ()).norm() < 1e-15);
  }

  void takes_the_assembly_whose_spokes_point_outwards() {
    // atan instead of atan2 would return theta - pi here.
    const Planar3Rrp::State s = assembled({3.0, 3.0 + phase_angle[1], 3.0 + phase_angle[2]});
    QVERIFY(std::abs(s.theta - 3.0) < 1e-15);
    QVERIFY(s.rho.sum() > 0.0);
  }

  void refuses_what_cannot_be_assembled_data() {
    QTest::addColumn<double>("phi2");
    QTest::addColumn<double>("phi3");
    QTest::addColumn<QString>("reason");
    QTest::newRow("three pins evenly opposed: no mean direction")
        << phase_angle[1] + 2 * pi / 3 << phase_angle[2] + 4 * pi / 3
        << "a spoke is turned by 90 deg or more";
    QTest::newRow("one ring half a turn away")
        << phase_angle[1] + pi << phase_angle[2] << "a spoke is turned by 90 deg or more";
    QTest::newRow("centre outside the pin circle")
        << phase_angle[1] - 2.618 << phase_angle[2] - 1.309 << "ring pins cannot reach";
    QTest::newRow("not a number") << std::nan("") << 0.0 << "a coordinate is not a finite number";
  }
  void refuses_what_cannot_be_assembled() {
    QFETCH(double, phi2);
    QFETCH(double, phi3);
    QFETCH(QString, reason);
    Planar3Rrp::State s;
    QCOMPARE(QString(describe(rings.forward({0.0, phi2, phi3}, s))), reason);
  }

  void refuses_a_centre_on_or_outside_the_pin_circle() {
    Vector3d phi;
    QCOMPARE(rings.inverse({.0901, 0}, 0, phi), AssemblyStatus::ring_pins_cannot_reach);
    QCOMPARE(rings.inverse({.090, 0}, 0, phi), AssemblyStatus::ring_pins_cannot_reach);
    QCOMPARE(rings.inverse({0, 0}, std::nan(""), phi), AssemblyStatus::not_finite);
  }
};

QTEST_APPLESS_MAIN(TestPlanar3Rrp)
#include "tst_planar_3rrp.moc"
