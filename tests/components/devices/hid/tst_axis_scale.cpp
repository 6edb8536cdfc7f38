// SPDX-License-Identifier: Apache-2.0
#include "components/devices/hid/axis_scale.hpp"

#include <QTest>
#include <cmath>
#include <limits>

using namespace trocar;
using namespace trocar::hid;

namespace {

const LimitsPage limits{{200, 200, 200, 12, 12, 12}, {2, 2, 2, 20, 20, 20}};
const CalibrationPage calibration{{2e-6f, -2e-6f, 2e-6f, 1e-4f, 1e-4f, 1e-4f},
                                  {0, 100, 0, 0, 0, -5}};

}  // namespace

class TestAxisScale : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void positions() {
    const Joints q = AxisScale(limits, calibration).position({-155'000, 600, 0, 1, 0, 5});
    QVERIFY(std::abs(q[0] + 0.310) < 1e-8);
    QVERIFY(std::abs(q[1] + 1e-3) < 1e-9);
    QVERIFY(std::abs(q[3] - 1e-4) < 1e-9);
    QVERIFY(std::abs(q[5] - 1e-3) < 1e-9);
  }

  void efforts_go_there_and_back_within_half_a_count() {
    const AxisScale scale(limits, calibration);
    Joints hold, total;
    for (int i = 0; i < 6; ++i) {
      hold[i] = i < 3 ? 20.5 * i : 0.3 * i;
      total[i] = (i < 3 ? 33.3 : 9.99) * (i % 2 ? -1 : 1);
    }
    CommandReport command;
    scale.put(hold, total, command);
    PerAxis<std::int16_t> sum;
    for (std::size_t i = 0; i < axes; ++i)
      sum[i] = static_cast<std::int16_t>(command.hold[i] + command.effort[i]);
    for (int i = 0; i < 6; ++i) {
      const double half = (i < 3 ? 200.0 : 12.0) / effort_max / 2;
      QVERIFY(std::abs(scale.effort(sum)[i] - total[i]) <= half * 1.0001);
      QVERIFY(std::abs(scale.effort(command.hold)[i] - hold[i]) <= half * 1.0001);
    }
  }

  void a_hold_that_is_opposed_beyond_the_peak_keeps_the_total() {
    Joints hold, total;
    hold[3] = 7.0;
    total[3] = -9.0;
    CommandReport command;
    AxisScale(limits, calibration).put(hold, total, command);
    QCOMPARE(int(command.effort[3]), -32767);
    QCOMPARE(command.hold[3] + command.effort[3], int(std::round(-9.0 / 12.0 * 32767)));
  }

  void what_it_writes_is_never_malformed_data() {
    QTest::addColumn<double>("hold");
    QTest::addColumn<double>("total");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double hold : {0.0, 12.3, 200.0, -200.0, 1e9, -1e9, nan, infinity})
      for (const double total : {0.0, -33.3, 200.0, -200.0, 200.003, 1e300, nan, -infinity})
        QTest::addRow("%g %g", hold, total) << hold << total;
  }
  void what_it_writes_is_never_malformed() {
    QFETCH(double, hold);
    QFETCH(double, total);
    Joints h, t;
    for (int i = 0; i < 6; ++i) h[i] = hold, t[i] = total;
    CommandReport command, back;
    AxisScale(limits, calibration).put(h, t, command);
    Report report;
    encode(command, report);
    QCOMPARE(decode(report, back), ReportDefect::none);
  }
};

QTEST_APPLESS_MAIN(TestAxisScale)
#include "tst_axis_scale.moc"
