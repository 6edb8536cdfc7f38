// SPDX-License-Identifier: Apache-2.0
#include "framework/signal_math.hpp"

#include <QTest>
#include <cmath>
#include <stdexcept>
#include <vector>

using namespace trocar;
using Values = std::vector<double>;

Q_DECLARE_METATYPE(Values)

class TestSignalMath : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_line_is_found_exactly() {
    const LineFit fit = fit_line(Values{-1, 0, 2, 5}, Values{-5, -2, 4, 13});
    QCOMPARE(fit.slope, 3.0);
    QCOMPARE(fit.offset, -2.0);
    QCOMPARE(fit.r2, 1.0);
    QCOMPARE(fit.inverse_slope, 1.0 / 3.0);
    QVERIFY(fit.rms < 1e-12);
    QCOMPARE(fit.count, std::size_t{4});
  }

  /// F. J. Anscombe, Graphs in statistical analysis, The American Statistician 27 (1973), 17-21:
  /// four sets with the same line, y = 3 + 0.5 x, and r² = 0.67.
  void the_lines_of_anscombes_quartet_data() {
    QTest::addColumn<Values>("x");
    QTest::addColumn<Values>("y");
    const Values x = {10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5};
    QTest::newRow("I") << x
                       << Values{8.04, 6.95, 7.58, 8.81, 8.33, 9.96, 7.24, 4.26, 10.84, 4.82, 5.68};
    QTest::newRow("II") << x
                        << Values{9.14, 8.14, 8.74, 8.77, 9.26, 8.10, 6.13, 3.10, 9.13, 7.26, 4.74};
    QTest::newRow("III") << x << Values{7.46, 6.77, 12.74, 7.11, 7.81, 8.84,
                                        6.08, 5.39, 8.15,  6.42, 5.73};
    QTest::newRow("IV") << Values{8, 8, 8, 8, 8, 8, 8, 19, 8, 8, 8}
                        << Values{6.58, 5.76,  7.71, 8.84, 8.47, 7.04,
                                  5.25, 12.50, 5.56, 7.91, 6.89};
  }
  void the_lines_of_anscombes_quartet() {
    QFETCH(Values, x);
    QFETCH(Values, y);
    const LineFit fit = fit_line(x, y);
    QVERIFY(std::abs(fit.slope - 0.500) < 0.001);
    QVERIFY(std::abs(fit.offset - 3.00) < 0.01);
    QVERIFY(std::abs(fit.r2 - 0.667) < 0.001);
    // Sum of squared residuals 13.75 in the paper, over 11 points.
    QVERIFY(std::abs(fit.rms * fit.rms * 11.0 - 13.75) < 0.05);
    QVERIFY(std::abs(fit.slope * fit.inverse_slope - fit.r2) < 1e-12);
  }

  void points_far_from_the_origin_lose_nothing() {
    Values x, y;
    for (int i = 0; i < 1000; ++i) {
      x.push_back(1e6 + i * 1e-3);
      y.push_back(2.2 * (i * 1e-3) + 5.0);
    }
    QVERIFY(std::abs(fit_line(x, y).slope - 2.2) < 1e-6);
  }

  void a_level_line_explains_everything() {
    const LineFit fit = fit_line(Values{1, 2, 3}, Values{4, 4, 4});
    QCOMPARE(fit.slope, 0.0);
    QCOMPARE(fit.offset, 4.0);
    QCOMPARE(fit.r2, 1.0);
    QCOMPARE(fit.inverse_slope, 0.0);
  }

  void what_has_no_line_is_refused_data() {
    QTest::addColumn<Values>("x");
    QTest::addColumn<Values>("y");
    QTest::newRow("nothing") << Values{} << Values{};
    QTest::newRow("one point") << Values{1} << Values{1};
    QTest::newRow("all above each other") << Values{2, 2, 2} << Values{1, 2, 3};
    QTest::newRow("another number of y") << Values{1, 2, 3} << Values{1, 2};
    QTest::newRow("no number in x") << Values{1, std::nan(""), 3} << Values{1, 2, 3};
  }
  void what_has_no_line_is_refused() {
    QFETCH(Values, x);
    QFETCH(Values, y);
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, fit_line(x, y));
  }

  void a_summary_says_mean_rms_ends_and_extremes() {
    const SignalSummary summary = summarise(Values{3, -4, 1, 2});
    QCOMPARE(summary.mean, 0.5);
    QCOMPARE(summary.rms, std::sqrt(30.0 / 4.0));
    QCOMPARE(summary.min, -4.0);
    QCOMPARE(summary.max, 3.0);
    QCOMPARE(summary.first, 3.0);
    QCOMPARE(summary.last, 2.0);
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, summarise(Values{}));
  }
};

QTEST_APPLESS_MAIN(TestSignalMath)
#include "tst_signal_math.moc"
