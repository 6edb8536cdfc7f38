// SPDX-License-Identifier: Apache-2.0
#include "components/devices/motor_temperature.hpp"

#include <QtTest>
#include <cmath>

#include "tests/support/allocation_counter.hpp"

using namespace trocar;

namespace {

MotorTemperature motors(const LaparoscopeDriveSettings& settings = {}) {
  return {settings, Imperfections{}};
}

}  // namespace

class TestMotorTemperature : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_winding_warms_along_its_exponential_data() {
    QTest::addColumn<double>("slider");    // [N]
    QTest::addColumn<double>("ring");      // [N m]
    QTest::addColumn<double>("duration");  // [s]
    QTest::addColumn<int>("steps");
    QTest::newRow("at the continuous effort, one step of a time constant")
        << 60.0 << 2.7 << 60.0 << 1;
    QTest::newRow("the same in milliseconds") << -60.0 << -2.7 << 60.0 << 60000;
    QTest::newRow("at half of it, in the end") << 30.0 << 1.35 << 1200.0 << 7;
    QTest::newRow("at the peak, for 2 s") << 200.0 << 12.0 << 2.0 << 2000;
  }
  void a_winding_warms_along_its_exponential() {
    QFETCH(double, slider);
    QFETCH(double, ring);
    QFETCH(double, duration);
    QFETCH(int, steps);
    MotorTemperature m = motors();
    for (int i = 0; i < steps; ++i) m.advance(duration / steps, both(slider, ring));
    const double grown = 1.0 - std::exp(-duration / 60.0);
    const Vector6d expected =
        both(80.0 * std::pow(slider / 60.0, 2) * grown, 80.0 * std::pow(ring / 2.7, 2) * grown);
    QVERIFY((m.rise() - expected).norm() < 1e-9 * expected.norm());
  }

  void it_cools_to_a_half_in_ln_2_time_constants() {
    MotorTemperature m = motors();
    m.start(both(40.0, 60.0), both(0.0, 0.0));
    m.advance(60.0 * std::log(2.0), Vector6d::Zero());
    QVERIFY((m.rise() - both(20.0, 30.0)).norm() < 1e-12);
  }

  void the_limit_falls_from_peak_to_continuous_data() {
    QTest::addColumn<double>("rise");    // [K]
    QTest::addColumn<double>("slider");  // [N]
    QTest::addColumn<double>("ring");    // [N m]
    QTest::newRow("cold") << 0.0 << 200.0 << 12.0;
    QTest::newRow("where it begins") << 64.0 << 200.0 << 12.0;
    QTest::newRow("half way") << 72.0 << 130.0 << 7.35;
    QTest::newRow("as warm as may be") << 80.0 << 60.0 << 2.7;
    QTest::newRow("warmer") << 100.0 << 60.0 << 2.7;
  }
  void the_limit_falls_from_peak_to_continuous() {
    QFETCH(double, rise);
    QFETCH(double, slider);
    QFETCH(double, ring);
    MotorTemperature m = motors();
    m.start(both(rise, rise), both(0.0, 0.0));
    QVERIFY((m.limited(both(1e3, 1e3)) - both(slider, ring)).norm() < 1e-9);
    QVERIFY((m.limited(both(-1e3, -1e3)) + both(slider, ring)).norm() < 1e-9);
    QCOMPARE(m.limited(both(59.0, -2.6)), both(59.0, -2.6));
  }

  void full_effort_for_ever_ends_at_the_continuous_one_and_never_overheats() {
    MotorTemperature m = motors();
    double first = 0.0;
    for (int k = 0; k < 1'200'000; ++k) {
      const Vector6d effort = m.limited(both(200.0, 12.0));
      if (first == 0.0 && effort[0] < 200.0) first = 1e-3 * k;
      m.advance(1e-3, effort);
      QVERIFY(m.rise().maxCoeff() <= 80.0 + 1e-9);
    }
    const double expected = -60.0 * std::log(1.0 - 0.8 * std::pow(60.0 / 200.0, 2));
    QVERIFY2(std::abs(first - expected) < 2e-3, qPrintable(QString::number(first)));
    QVERIFY((m.limited(both(200.0, 12.0)) - both(60.0, 2.7)).norm() < 1e-3);
  }

  void magnets_follow_and_lose_gain() {
    LaparoscopeDriveSettings s;
    MotorTemperature m = motors(s);
    QCOMPARE(m.gain(), Vector6d(Vector6d::Ones()));
    const double step = 0.1, duration = 300.0;
    for (int k = 0; k < 3000; ++k) m.advance(step, both(30.0, 1.35));
    // Two lags in a row, of 60 s and 600 s, on a step to 20 K and half of it.
    const double rise =
        0.5 * 20.0 *
        (1.0 - (600.0 * std::exp(-duration / 600.0) - 60.0 * std::exp(-duration / 60.0)) / 540.0);
    QVERIFY2((m.magnet_rise() - both(rise, rise)).norm() < 1e-5,
             qPrintable(QString::number(m.magnet_rise()[0] - rise)));
    QVERIFY((m.gain() - both(1.0 - 1e-3 * rise, 1.0 - 1e-3 * rise)).norm() < 1e-8);
  }

  void each_effect_has_its_switch() {
    Imperfections with = Imperfections::none();
    MotorTemperature m({}, with);
    m.start(both(100.0, 100.0), both(50.0, 50.0));
    QCOMPARE(m.limited(both(200.0, 12.0)), both(200.0, 12.0));
    QCOMPARE(m.gain(), Vector6d(Vector6d::Ones()));
  }

  void it_does_not_allocate() {
    MotorTemperature m = motors();
    Vector6d sum = Vector6d::Zero();
    QCOMPARE(test::allocations_in([&] {
               for (int k = 0; k < 1000; ++k) {
                 m.advance(1e-3, both(100.0, 5.0));
                 sum += m.limited(both(200.0, 12.0));
               }
             }),
             0);
    QVERIFY(sum.norm() > 1.0);
  }
};

QTEST_APPLESS_MAIN(TestMotorTemperature)
#include "tst_motor_temperature.moc"
