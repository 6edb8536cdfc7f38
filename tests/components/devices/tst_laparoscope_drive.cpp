// SPDX-License-Identifier: Apache-2.0
#include "components/devices/laparoscope_drive.hpp"

#include <QTest>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "components/devices/seeded_random.hpp"

using namespace trocar;

namespace {

Imperfections only(bool Imperfections::*one) {
  Imperfections i = Imperfections::none();
  i.*one = true;
  return i;
}

Vector6d all(double value) {
  return Vector6d::Constant(value);
}

}  // namespace

class TestLaparoscopeDrive : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void without_imperfections_nothing_is_changed() {
    const LaparoscopeDrive drive({}, Imperfections::none(), 1);
    const Vector6d x = (Vector6d() << 1e3, -.1234567, 3, 1e-9, 50, -7).finished();
    QCOMPARE(drive.effort(drive.sent(x), x), x);
    QCOMPARE(drive.read(x), x);
    QVERIFY(drive.dry_friction(Vector6d::Zero()).isZero(0.0) && drive.viscous().isZero(0.0));
  }

  void dac_has_14_bits_over_both_peaks() {
    const LaparoscopeDrive drive({}, only(&Imperfections::effort_quantisation), 1);
    const double slider = 200.0 / 8192, ring = 12.0 / 8192;
    QCOMPARE(drive.sent(all(0.49 * slider))[0], 0.0);
    QCOMPARE(drive.sent(all(0.51 * slider))[0], slider);
    QCOMPARE(drive.sent(all(-2.6 * slider))[2], -3 * slider);
    QCOMPARE(drive.sent(all(0.51 * ring))[3], ring);
  }

  void effort_ends_at_the_peak() {
    const LaparoscopeDrive drive({}, only(&Imperfections::saturation), 1);
    const Vector6d top = drive.sent(all(500.0)), bottom = drive.sent(all(-500.0));
    QCOMPARE(top, (Vector6d() << 200, 200, 200, 12, 12, 12).finished());
    QCOMPARE(bottom, Vector6d(-top));
    QCOMPARE(drive.sent(all(11.99)), all(11.99));
  }

  void a_command_that_is_not_a_number_is_no_effort() {
    const LaparoscopeDrive drive({}, {}, 1);
    QCOMPARE(drive.sent(all(std::nan(""))), Vector6d(Vector6d::Zero()));
    QCOMPARE(drive.sent(all(HUGE_VAL))[0], 200.0);
  }

  void gains_lie_in_their_band_and_differ() {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const Vector6d gain = LaparoscopeDrive({}, only(&Imperfections::gain_error), seed).gain();
      QVERIFY((gain.array() >= 0.9615).all() && (gain.array() <= 0.9695).all());
      QVERIFY(gain.maxCoeff() > gain.minCoeff());
    }
  }

  void ripple_has_its_amplitude_and_pitch() {
    const LaparoscopeDrive drive({}, only(&Imperfections::force_ripple), 3);
    double high = 0.0, low = 1e9;
    for (int k = 0; k < 1000; ++k) {
      const Vector6d q = all(k * 25.6e-6);
      const double f = drive.effort(all(10.0), q)[1];
      high = std::max(high, f);
      low = std::min(low, f);
      QVERIFY(std::abs(drive.effort(all(10.0), q + all(25.6e-3))[1] - f) < 1e-12);
      QVERIFY(std::abs(drive.effort(all(10.0), q + all(32e-3))[4] - drive.effort(all(10.0), q)[4]) <
              1e-12);
    }
    QVERIFY(std::abs(high - 10.07) < 1e-5 && std::abs(low - 9.93) < 1e-5);
  }

  void cogging_pulls_without_effort_and_takes_no_energy_over_its_pitch() {
    const LaparoscopeDrive drive({}, only(&Imperfections::cogging), 3);
    double most = 0.0, sum = 0.0;
    for (int k = 0; k < 1000; ++k) {
      const double f = drive.effort(all(0.0), all(k * 12.8e-6))[0];
      most = std::max(most, std::abs(f));
      sum += f;
      QVERIFY(std::abs(drive.effort(all(7.0), all(k * 12.8e-6))[0] - 7.0 - f) < 1e-12);
    }
    QVERIFY(std::abs(most - 0.05) < 1e-6 && std::abs(sum) < 1e-9);
    double ring = 0.0;
    for (int k = 0; k < 1000; ++k) ring = std::max(ring, drive.effort(all(0.0), all(k * 16e-6))[5]);
    QVERIFY(std::abs(ring - 1e-3) < 1e-7);
  }

  void encoders_round_to_their_counts() {
    const LaparoscopeDrive drive({}, only(&Imperfections::position_quantisation), 1);
    QVERIFY(std::abs(drive.read(all(-.2500009))[0] + .250000) < 1e-15);
    QVERIFY(std::abs(drive.read(all(-.2500011))[0] + .250002) < 1e-15);
    const double count = 2 * std::numbers::pi / 61440;
    QVERIFY(std::abs(count - 1.02e-4) < 1e-6);
    QVERIFY(std::abs(drive.read(all(7.4 * count))[5] - 7 * count) < 1e-15);
  }

  void homing_errors_lie_in_their_bands() {
    bool negative = false, positive = false;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const LaparoscopeDrive drive({}, only(&Imperfections::homing_error), seed);
      const Vector6d error = drive.read(Vector6d::Zero());
      QCOMPARE(error, drive.homing_error());
      for (int i = 0; i < 3; ++i) {
        QVERIFY(std::abs(error[i]) >= 0.1e-3 && std::abs(error[i]) <= 0.2e-3);
        QVERIFY(std::abs(error[3 + i]) <= 1e-3);
        (error[i] < 0.0 ? negative : positive) = true;
      }
    }
    QVERIFY(negative && positive);
  }

  void the_seed_decides_and_other_switches_do_not() {
    const LaparoscopeDrive a({}, {}, 42), b({}, {}, 42), c({}, {}, 43);
    QCOMPARE(a.gain(), b.gain());
    QCOMPARE(a.homing_error(), b.homing_error());
    QVERIFY(a.gain() != c.gain() && a.homing_error() != c.homing_error());
    QCOMPARE(LaparoscopeDrive({}, only(&Imperfections::homing_error), 42).homing_error(),
             a.homing_error());
  }

  void the_generator_is_the_published_one() {
    SeededRandom random(0);  // SplitMix64 of 0 begins with e220a8397b1dcdaf
    const double first = static_cast<double>(0xe220a8397b1dcdafu >> 11) * 0x1p-53;
    QCOMPARE(random.uniform(0.0, 1.0), first);
  }

  void impossible_settings_are_refused_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<QString>("expected");
    QTest::newRow("one bit") << 0 << "dac_bits = 1: needs 2 to 32 bits";
    QTest::newRow("no gain") << 1 << "gain = 0: needs a value above 0";
    QTest::newRow("no peak") << 2 << "peak = 0: needs an effort above 0";
    QTest::newRow("no resolution") << 3 << "resolution = 0: needs a value above 0";
    QTest::newRow("ripple beyond the effort") << 4 << "ripple = 1.5: needs a value from 0";
    QTest::newRow("continuous above the peak") << 5 << "continuous = 300: needs an effort above 0";
    QTest::newRow("less friction at rest") << 6 << "static_friction = 0.9: needs a value of";
    QTest::newRow("a winding of no time") << 7 << "thermal.time = 0: needs a value above 0";
    QTest::newRow("no limit before it is too hot") << 8 << "derating_start = 1: needs a value";
  }
  void impossible_settings_are_refused() {
    QFETCH(int, which);
    QFETCH(QString, expected);
    LaparoscopeDriveSettings s;
    if (which == 0) s.dac_bits = 1;
    if (which == 1) s.gain = 0.0;
    if (which == 2) s.ring.peak = 0.0;
    if (which == 3) s.slider.resolution = 0.0;
    if (which == 4) s.ripple = 1.5;
    if (which == 5) s.slider.continuous = 300.0;
    if (which == 6) s.static_friction = 0.9;
    if (which == 7) s.thermal.time = 0.0;
    if (which == 8) s.thermal.derating_start = 1.0;
    try {
      const LaparoscopeDrive drive(s, {}, 1);
      QFAIL("accepted");
    } catch (const std::invalid_argument& error) {
      QVERIFY2(QString(error.what()).contains(expected), error.what());
    }
  }
};

QTEST_APPLESS_MAIN(TestLaparoscopeDrive)
#include "tst_laparoscope_drive.moc"
