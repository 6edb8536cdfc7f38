// SPDX-License-Identifier: Apache-2.0
#include "components/devices/report_channel.hpp"

#include <QtTest>
#include <cmath>

using namespace trocar;

class TestReportChannel : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void reports_are_lost_at_their_rate_and_in_runs_data() {
    QTest::addColumn<double>("loss");
    QTest::addColumn<double>("run");
    QTest::newRow("none") << 0.0 << 1.0;
    QTest::newRow("one in a hundred, alone") << 0.01 << 1.0;
    QTest::newRow("as independent ones") << 0.2 << 1.25;
    QTest::newRow("in runs of ten") << 0.05 << 10.0;
    QTest::newRow("half, in runs of three") << 0.5 << 3.0;
  }
  void reports_are_lost_at_their_rate_and_in_runs() {
    QFETCH(double, loss);
    QFETCH(double, run);
    ReportChannel channel({.loss = loss, .loss_run = run}, 5);
    constexpr int reports = 2'000'000;
    int lost = 0, runs = 0;
    bool before = false;
    for (int k = 0; k < reports; ++k) {
      const bool now = !channel.next().arrives;
      lost += now;
      runs += now && !before;
      before = now;
    }
    // Runs are independent: their number is known to a part in its root, their sum as well.
    const double expected = loss * reports;
    if (loss == 0.0) {
      QCOMPARE(lost, 0);
      return;
    }
    const double tolerance = 5.0 * run * std::sqrt(2.0 * expected / run);
    QVERIFY2(std::abs(lost - expected) < tolerance, qPrintable(QString::number(lost)));
    const double mean = static_cast<double>(lost) / runs;
    QVERIFY2(std::abs(mean / run - 1.0) < 5.0 / std::sqrt(runs), qPrintable(QString::number(mean)));
  }

  void jitter_is_even_and_bounded() {
    ReportChannel channel({.jitter = 0.4}, 5);
    double sum = 0.0, squares = 0.0, most = 0.0;
    constexpr int reports = 100'000;
    for (int k = 0; k < reports; ++k) {
      const double early = channel.next().early;
      QVERIFY(early >= 0.0 && early < 0.4);
      sum += early;
      squares += early * early;
      most = std::max(most, early);
    }
    const double mean = sum / reports;
    QVERIFY(std::abs(mean - 0.2) < 2e-3 && most > 0.399);
    QVERIFY(std::abs(squares / reports - mean * mean - 0.16 / 12.0) < 2e-4);
  }

  void the_seed_decides() {
    const ReportSettings settings{.jitter = 1.0, .loss = 0.3};
    const auto number = [&](std::uint64_t seed) {
      ReportChannel channel(settings, seed);
      double sum = 0.0;
      for (int k = 0; k < 100; ++k) {
        const auto report = channel.next();
        sum += report.early + 2.0 * k * report.arrives;
      }
      return sum;
    };
    QCOMPARE(number(1), number(1));
    QVERIFY(number(1) != number(2));
  }
};

QTEST_APPLESS_MAIN(TestReportChannel)
#include "tst_report_channel.moc"
