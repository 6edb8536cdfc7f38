// SPDX-License-Identifier: Apache-2.0
#include "components/devices/dry_friction.hpp"

#include <QtTest>

using namespace trocar;

namespace {

Vector6d all(double value) {
  return Vector6d::Constant(value);
}

}  // namespace

class TestDryFriction : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_falls_along_stribecks_curve_data() {
    QTest::addColumn<double>("speeds");    // in Stribeck's
    QTest::addColumn<double>("expected");  // [N]
    QTest::newRow("at rest: the static friction") << 0.0 << 0.6;
    QTest::newRow("slow") << 0.5 << 0.4 + 0.2 * std::exp(-0.25);
    QTest::newRow("at Stribeck's speed") << 1.0 << 0.4 + 0.2 * std::exp(-1.0);
    QTest::newRow("backwards") << -1.0 << 0.4 + 0.2 * std::exp(-1.0);
    QTest::newRow("fast: Coulomb's") << 10.0 << 0.4;
  }
  void it_falls_along_stribecks_curve() {
    QFETCH(double, speeds);
    QFETCH(double, expected);
    const DryFriction friction(all(0.4), 1.5, all(2e-3));
    for (int i = 0; i < 6; ++i)
      QVERIFY(std::abs(friction.limit(all(speeds * 2e-3))[i] - expected) < 1e-15);
  }

  void where_the_exponential_is_left_out_there_is_no_step() {
    const DryFriction friction(all(0.4), 5.0, all(1.0));
    QCOMPARE(friction.limit(all(6.3245)), friction.limit(all(6.3247)));
  }

  void without_excess_it_is_coulombs() {
    const DryFriction friction(all(0.4), 1.0, all(2e-3));
    QCOMPARE(friction.limit(all(0.0)), all(0.4));
    QCOMPARE(friction.limit(all(1e-3)), all(0.4));
  }
};

QTEST_APPLESS_MAIN(TestDryFriction)
#include "tst_dry_friction.moc"
