// SPDX-License-Identifier: Apache-2.0
#include "components/devices/series_compliance.hpp"

#include <QtTest>
#include <cmath>
#include <numbers>
#include <stdexcept>

using namespace trocar;

namespace {

const Vector6d axis = both(0.320, 5e-3);  // [kg, kg m^2]
const Vector6d zero = Vector6d::Zero();

SeriesCompliance springs(double damping = 0.0) {
  LaparoscopeDriveSettings s;
  s.transmission_damping = damping;
  return {s, axis};
}

/// Motors alone: the mechanism stands still at 0.
void step(SeriesCompliance& s, double h, const Vector6d& effort, const Vector6d& viscous,
          const Vector6d& dry) {
  s.drift(0.5 * h);
  s.kick(h, effort - s.effort(zero, zero), viscous, dry);
  s.drift(0.5 * h);
}

}  // namespace

class TestSeriesCompliance : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void at_rest_it_is_stretched_by_force_over_stiffness() {
    SeriesCompliance s = springs();
    const Vector6d effort = both(80.0, -2.0);
    s.rest(both(0.1, 0.2), zero, effort);
    QVERIFY((s.position() - both(0.1 + 80.0 / 8e6, 0.2 - 2.0 / 100e3)).norm() < 1e-15);
    QVERIFY((s.effort(both(0.1, 0.2), zero) - effort).norm() < 1e-8);
    const double energy = 3 * 0.5 * 80.0 * 80.0 / 8e6 + 3 * 0.5 * 2.0 * 2.0 / 100e3;
    QVERIFY(std::abs(s.energy(both(0.1, 0.2)) / energy - 1.0) < 1e-8);
  }

  void a_motor_swings_on_its_spring_at_its_frequency_and_keeps_its_energy() {
    SeriesCompliance s = springs();
    s.rest(zero, zero, both(80.0, 2.0));
    const double start = s.energy(zero);
    const double h = 1e-5;
    // After whole periods of the slider's motor, it is back.
    const double period = 2.0 * std::numbers::pi * std::sqrt(0.160 / 8e6);
    const int steps = static_cast<int>(std::lround(5.0 * period / h));
    double worst = 0.0;
    for (int k = 0; k < steps; ++k) {
      step(s, h, zero, zero, zero);
      worst = std::max(worst, std::abs(s.energy(zero) / start - 1.0));
    }
    QVERIFY2(worst < 2e-3, qPrintable(QString::number(worst)));
    QVERIFY(std::abs(s.position()[0] / (80.0 / 8e6) - 1.0) < 0.02);
  }

  void damping_takes_energy_at_its_rate() {
    SeriesCompliance s = springs(0.05);
    s.rest(zero, zero, both(80.0, 2.0));
    const double start = s.energy(zero);
    for (int k = 0; k < 100; ++k) step(s, 1e-5, zero, zero, zero);
    // The motor alone: d / J with d = 2 zeta sqrt(k m), m the reduced mass 80 g.
    const double d = 2.0 * 0.05 * std::sqrt(8e6 * 0.080);
    const double slider = 3 * 0.5 * 80.0 * 80.0 / 8e6;
    const double ring_d = 2.0 * 0.05 * std::sqrt(100e3 * 3.195e-3 * 1.805e-3 / 5e-3);
    const double expected = slider * std::exp(-d / 0.160 * 1e-3) +
                            (start - slider) * std::exp(-ring_d / 3.195e-3 * 1e-3);
    // Within a cycle energy falls as the velocity's square says: d / (2 J omega) of modulation.
    QVERIFY2(std::abs(s.energy(zero) / expected - 1.0) < 0.04,
             qPrintable(QString::number(s.energy(zero) / expected)));
  }

  void at_the_longest_step_it_is_stable() {
    SeriesCompliance s = springs(0.05);
    s.rest(zero, zero, both(80.0, 2.0));
    const double start = s.energy(zero);
    for (int k = 0; k < 10000; ++k) step(s, s.longest_step(), zero, zero, zero);
    QVERIFY(s.energy(zero) < 1e-3 * start);
    QVERIFY2(s.longest_step() > 1e-4, "the default physics step of the device");
  }

  void dry_friction_holds_the_motor_exactly_and_no_more_than_it_can() {
    SeriesCompliance s = springs();
    for (int k = 0; k < 1000; ++k) step(s, 1e-4, both(0.34, 0.012), zero, both(0.35, 0.013));
    QCOMPARE(s.position(), zero);
    s.kick(1e-4, both(0.45, -0.02), zero, both(0.35, 0.013));
    QVERIFY((s.velocity() - both(1e-4 * 0.10 / 0.160, -1e-4 * 0.007 / 3.195e-3)).norm() < 1e-15);
  }

  void viscous_friction_is_taken_by_the_trapezoidal_rule() {
    SeriesCompliance s = springs();
    s.rest(zero, both(0.1, 1.0), zero);
    s.kick(1e-3, zero, both(8.0, 0.06), zero);
    const double slider = (0.160 - 4e-3) / (0.160 + 4e-3),
                 ring = (3.195e-3 - 3e-5) / (3.195e-3 + 3e-5);
    QVERIFY((s.velocity() - both(0.1 * slider, ring)).norm() < 1e-14);
  }

  void motors_that_leave_nothing_of_the_axis_are_refused() {
    LaparoscopeDriveSettings s;
    s.slider.motor_inertia = 0.4;
    try {
      const SeriesCompliance refused(s, axis);
      QFAIL("accepted");
    } catch (const std::invalid_argument& error) {
      QVERIFY2(QString(error.what()).contains("lower slider_motor_mass"), error.what());
    }
  }
};

QTEST_APPLESS_MAIN(TestSeriesCompliance)
#include "tst_series_compliance.moc"
