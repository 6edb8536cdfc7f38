// SPDX-License-Identifier: Apache-2.0
#include "framework/least_squares.hpp"

#include <QTest>
#include <cmath>
#include <stdexcept>
#include <vector>

using namespace trocar;
using Values = std::vector<double>;
using Columns = std::vector<Values>;

class TestLeastSquares : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_parabola_is_found_exactly_whatever_the_units() {
    Columns columns(3);
    Values target;
    for (int i = 0; i < 9; ++i) {
      const double x = 0.5 * i - 1.0;
      columns[0].push_back(1e-9);  // as if in other units
      columns[1].push_back(1e6 * x);
      columns[2].push_back(x * x);
      target.push_back(3.0 - 2.0 * x + 0.25 * x * x);
    }
    const LinearFit fit = fit_linear(columns, target);
    QVERIFY(std::abs(fit.solution[0] - 3e9) < 1.0);
    QVERIFY(std::abs(fit.solution[1] + 2e-6) < 1e-15);
    QVERIFY(std::abs(fit.solution[2] - 0.25) < 1e-9);
    QVERIFY(fit.rms < 1e-12);
    QVERIFY(1.0 - fit.r2 < 1e-12);
  }

  /// y = p + e with n rows: the error of the mean is s / sqrt(n), s² = |e|² / (n - 1).
  void the_error_of_a_mean() {
    const LinearFit fit = fit_linear(Columns{{1, 1, 1, 1}}, Values{1, 3, 5, 7});
    QVERIFY(std::abs(fit.solution[0] - 4.0) < 1e-12);
    QVERIFY(std::abs(fit.errors[0] - std::sqrt(20.0 / 3.0 / 4.0)) < 1e-12);
    QVERIFY(std::abs(fit.rms - std::sqrt(5.0)) < 1e-12);
    QVERIFY(std::abs(fit.r2) < 1e-12);
  }

  void refused_data() {
    QTest::addColumn<QVector<QVector<double>>>("columns");
    QTest::addColumn<QString>("says");
    using Lists = QVector<QVector<double>>;
    QTest::newRow("no column") << Lists{} << "at least one column";
    QTest::newRow("fewer rows than columns")
        << Lists{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}} << "3 rows for 4 columns";
    QTest::newRow("another length") << Lists{{1, 2}} << "column 1 has 2 rows, the target 3";
    QTest::newRow("nothing in it") << Lists{{1, 2, 3}, {0, 0, 0}} << "column 2 is all zero";
    QTest::newRow("a column that others give")
        << Lists{{1, 2, 3}, {2, 4, 6}} << "depends on the others";
  }
  void refused() {
    QFETCH(QVector<QVector<double>>, columns);
    QFETCH(QString, says);
    Columns given;
    for (const auto& column : columns) given.emplace_back(column.begin(), column.end());
    try {
      fit_linear(given, Values{1, 2, 4});
      QFAIL("nothing was refused");
    } catch (const std::invalid_argument& error) {
      QVERIFY2(QString(error.what()).contains(says), error.what());
    }
  }
};

QTEST_APPLESS_MAIN(TestLeastSquares)
#include "tst_least_squares.moc"
