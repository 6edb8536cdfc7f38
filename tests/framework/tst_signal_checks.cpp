// SPDX-License-Identifier: Apache-2.0
#include "framework/signal_checks.hpp"

#include <QTest>
#include <cmath>
#include <limits>

using namespace trocar;

class TestSignalChecks : public QObject {
  Q_OBJECT

  const std::vector<double> pulse_{0.0, 1.0, 4.0, 2.0, 0.5, 0.1, -0.1, 0.0};
  const double nan_ = std::nan("");

 private Q_SLOTS:
  void always_names_the_first_row_that_does_not_hold() {
    QVERIFY(always(pulse_, Comparison::less_or_equal, 4.0).holds);
    const SignalVerdict verdict = always(pulse_, Comparison::less, 2.0);
    QVERIFY(!verdict.holds);
    QCOMPARE(verdict.row, 2U);
    QCOMPARE(verdict.count, 2U);
  }

  void a_number_that_is_not_finite_never_holds() {
    const std::vector<double> broken{0.0, nan_, std::numeric_limits<double>::infinity()};
    QCOMPARE(always(broken, Comparison::less, 1.0).row, 1U);
    QCOMPARE(always(broken, Comparison::greater, -1.0).count, 2U);
    QVERIFY(!eventually(broken, Comparison::greater, 5.0).holds);
    QVERIFY(!peaks(broken, 0.0, 1.0).holds);
    QVERIFY(!settles(std::vector<double>{0.0, nan_}, 0.0, 1.0).holds);
  }

  void eventually_names_the_first_row_or_the_nearest() {
    const SignalVerdict found = eventually(pulse_, Comparison::greater_or_equal, 2.0);
    QVERIFY(found.holds);
    QCOMPARE(found.row, 2U);
    const SignalVerdict nearest = eventually(pulse_, Comparison::greater, 5.0);
    QVERIFY(!nearest.holds);
    QCOMPARE(nearest.row, 2U);
    QCOMPARE(eventually(std::vector<double>{nan_, 3.0, 1.0}, Comparison::less, 0.0).row, 2U);
  }

  void it_settles_where_it_no_longer_leaves_the_band() {
    const SignalVerdict verdict = settles(pulse_, 0.0, 0.2);
    QVERIFY(verdict.holds);
    QCOMPARE(verdict.row, 5U);
    const SignalVerdict never = settles(pulse_, 1.0, 0.2);
    QVERIFY(!never.holds);
    QCOMPARE(never.row, pulse_.size() - 1);
    QVERIFY(!settles(std::vector<double>{}, 0.0, 1.0).holds);
  }

  void a_peak_is_on_the_side_of_its_target() {
    QVERIFY(peaks(pulse_, 4.0, 0.0).holds);
    QCOMPARE(peaks(pulse_, 3.0, 0.5).row, 2U);
    QVERIFY(!peaks(pulse_, 3.0, 0.5).holds);
    QVERIFY(peaks(pulse_, -0.1, 0.01).holds);
    QCOMPARE(peaks(pulse_, -0.1, 0.01).row, 6U);
  }

  void crossings_have_a_way_and_a_touch_is_none() {
    const std::vector<LevelCrossing> found = crossings(pulse_, 1.0);
    QCOMPARE(found.size(), 2U);
    QCOMPARE(found[0].row, 2U);
    QVERIFY(found[0].up);
    QCOMPARE(found[1].row, 4U);
    QVERIFY(!found[1].up);
    QVERIFY(crossings(std::vector<double>{0.0, 1.0, 0.0}, 1.0).empty());
    QVERIFY(crossings(std::vector<double>{1.0, 1.0, 2.0}, 1.0).empty());
    QCOMPARE(crossings(std::vector<double>{0.0, 1.0, 2.0}, 1.0).front().row, 2U);
  }

  void work_is_the_integral_of_the_power() {
    // F = (t, 1), v = (2, t): the power is 3 t, the work 1.5 t^2, which the rule has exactly.
    std::vector<std::vector<double>> force(2), velocity(2);
    std::vector<double> time;
    for (int i = 0; i <= 10; ++i) {
      const double t = 0.1 * i;
      time.push_back(t);
      force[0].push_back(t);
      force[1].push_back(1.0);
      velocity[0].push_back(2.0);
      velocity[1].push_back(t);
    }
    const std::vector<double> done = work(force, velocity, time);
    for (std::size_t i = 0; i < time.size(); ++i)
      QVERIFY(std::abs(done[i] - 1.5 * time[i] * time[i]) < 1e-12);
    QVERIFY_THROWS_EXCEPTION(std::invalid_argument, work(force, {velocity[0]}, time));
  }

  void comparisons_have_names() {
    for (const std::string& name : comparison_names()) {
      const auto comparison = comparison_named(name);
      QVERIFY(comparison.has_value());
      QCOMPARE(compare(1.0, *comparison, 1.0), name.ends_with('='));
      QCOMPARE(compare(0.0, *comparison, 1.0), name.starts_with('<'));
      QCOMPARE(compare(2.0, *comparison, 1.0), name.starts_with('>'));
    }
    QVERIFY(!comparison_named("=<"));
  }
};

QTEST_GUILESS_MAIN(TestSignalChecks)
#include "tst_signal_checks.moc"
