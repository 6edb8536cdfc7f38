// SPDX-License-Identifier: Apache-2.0
#include "components/devices/position_wave.hpp"

#include <QtTest>
#include <cmath>
#include <numbers>

using namespace trocar;

class TestPositionWave : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void its_sine_is_the_sine_to_1e_9() {
    double worst = 0.0;
    for (int k = -200'000; k <= 200'000; ++k) {
      const double turns = 1.7e-5 * k;
      worst = std::max(worst,
                       std::abs(sine_of_turns(turns) - std::sin(2.0 * std::numbers::pi * turns)));
    }
    QVERIFY2(worst < 1e-9, qPrintable(QString::number(worst)));
    for (const double turns : {0.0, 0.5, 1.0, -3.0, 1e9}) QVERIFY(sine_of_turns(turns) == 0.0);
    QVERIFY(std::isnan(sine_of_turns(std::nan(""))));
  }

  void each_axis_has_its_pitch_and_phase() {
    const Vector6d pitch = Vector6d::LinSpaced(1.0, 6.0), phase = Vector6d::LinSpaced(0.0, 0.5);
    const PositionWave wave(pitch, phase);
    const Vector6d w = wave.at(Vector6d::Constant(0.3));
    for (int i = 0; i < 6; ++i)
      QVERIFY(std::abs(w[i] - std::sin(2.0 * std::numbers::pi * (0.3 / pitch[i] + phase[i]))) <
              1e-9);
  }
};

QTEST_APPLESS_MAIN(TestPositionWave)
#include "tst_position_wave.moc"
