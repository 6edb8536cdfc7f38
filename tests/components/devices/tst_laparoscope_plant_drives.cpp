// SPDX-License-Identifier: Apache-2.0
// Drives, transmissions and dry friction as the mechanism feels them.
#include <QtTest>
#include <cmath>

#include "tests/support/plant_rig.hpp"

using namespace trocar;
using namespace trocar::test;
using Eigen::Vector3d;

class TestLaparoscopePlantDrives : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void with_stuck_motors_the_tip_yields_by_force_over_stiffness_data() {
    QTest::addColumn<int>("axis");
    QTest::addColumn<double>("stiffness");  // [N/m] as the parameters' documentation says
    QTest::newRow("x") << 0 << 3.0e6;
    QTest::newRow("y") << 1 << 3.0e6;
    QTest::newRow("z: three sliders") << 2 << 24.0e6;
  }
  void with_stuck_motors_the_tip_yields_by_force_over_stiffness() {
    QFETCH(int, axis);
    QFETCH(double, stiffness);
    LaparoscopePlantSettings s = ideal();
    s.imperfections.compliance = s.imperfections.coulomb_friction = true;
    s.start = {{0.0, 0.0, 0.085}, 0.0, 0.0, 0.0};
    s.drive.slider.coulomb = s.drive.ring.coulomb = 50.0;
    LaparoscopePlant plant(s);
    const Vector3d before = plant.configuration().tool.tip;
    const Vector6d motors = plant.motor_position();
    plant.load(10.0 * Vector6d::Unit(axis));
    run(plant, 0.5);
    QCOMPARE(plant.motor_position(), motors);
    const Matrix6d jacobian = rates_of(plant).jacobian;
    const Vector6d soft = both(1.0 / 8e6, 1.0 / 100e3);
    const Vector3d yields = plant.configuration().tool.tip - before;
    const Vector3d expected =
        (jacobian * soft.asDiagonal() * jacobian.transpose()).topLeftCorner<3, 3>().col(axis) *
        10.0;
    QVERIFY2((yields - expected).norm() < 1e-4 * expected.norm(),
             qPrintable(QString::number((yields - expected).norm())));
    QVERIFY(std::abs(10.0 / yields[axis] / stiffness - 1.0) < 0.01);
    QVERIFY(plant.velocity().norm() < 1e-9);
  }

  void motors_derate_as_they_warm() {
    LaparoscopePlantSettings s = ideal();
    s.imperfections.saturation = s.imperfections.derating = true;
    s.drive.thermal.time = 0.05;
    LaparoscopePlant plant(s);
    plant.apply(both(200.0, 0.0));
    QCOMPARE(plant.sent_effort()[0], 200.0);
    run(plant, 0.3);
    QVERIFY(std::abs(plant.sent_effort()[0] - 60.0) < 1.0);
    QVERIFY(plant.temperature().rise()[0] > 79.0 && plant.temperature().rise()[0] < 82.0);
    QCOMPARE(plant.temperature().rise()[3], 0.0);
  }

  void warm_magnets_hold_less_weight() {
    LaparoscopePlantSettings s = ideal();
    s.imperfections.gain_drift = true;
    s.gravity = standard_gravity;
    s.drive.thermal.magnet_time = s.drive.thermal.time = 1e-3;
    s.drive.thermal.gain_loss = 0.01;
    s.drive.slider.continuous = 4.0;
    LaparoscopePlant plant(s);
    const Vector6d held = weight_of(plant, s.gravity);
    plant.apply(held);
    run(plant, 0.05);
    // Each slider's rise, at once: 80 K (held / 4 N)^2, half of it at its magnets.
    const double share = 1.0 - 0.01 * 40.0 * std::pow(held[0] / 4.0, 2);
    QVERIFY2(std::abs(plant.gain()[0] - share) < 1e-6,
             qPrintable(QString::number(plant.gain()[0])));
    QVERIFY(plant.velocity()[0] < -0.01);
  }

  void a_stribeck_axis_breaks_away_late_and_then_slides_easily() {
    LaparoscopePlantSettings s = ideal();
    s.imperfections.coulomb_friction = s.imperfections.stribeck = true;
    LaparoscopePlant plant(s);
    const Vector6d before = plant.position();
    plant.apply(both(0.419, 0.0));  // static friction is 1.2 x 0.35 N
    run(plant, 0.2);
    QCOMPARE(plant.position(), before);
    plant.apply(both(0.43, 0.0));
    run(plant, 0.4);
    const double speed = plant.velocity()[0];
    plant.apply(both(0.43, 0.0));
    run(plant, 0.05);
    const double mass = plant.dynamics()
                            .inertia(plant.configuration(), rates_of(plant))
                            .mass.topLeftCorner<3, 3>()
                            .sum();
    const double expected = 3 * (0.43 - 0.35) / mass * 0.05;
    QVERIFY(speed > 0.02);
    QVERIFY(std::abs((plant.velocity()[0] - speed) / expected - 1.0) < 0.01);
  }
};

QTEST_APPLESS_MAIN(TestLaparoscopePlantDrives)
#include "tst_laparoscope_plant_drives.moc"
